#include "ros/simulator_farm_state.h"

#include "devo_evo/experiment/report_text.h"
#include "devo_evo/soft_body/text.h"
#include "ros/conversions.h"

#include <ros/console.h>

#include <algorithm>
#include <utility>

namespace devo_evo
{
namespace
{
constexpr std::chrono::seconds CLOSE_TIMEOUT{ 2 };
constexpr size_t MOST_SIMULATORS = 4096;
}  // namespace

SimulatorFarm::State::State(const SimulatorFarmSettings& settings, Referee referee)
  : settings_(settings)
  , body_(makeBody(settings.body))
  , referee_(std::move(referee))
  , call_timeout_(settings.batch_timeout * body_->relativeCost())
  , ledger_(settings.checked_fraction)
{
}

std::optional<SimulatorSession> SimulatorFarm::State::announced(const SimulatorAnnouncement& announcement,
                                                                const SimulatorConnector& connector)
{
  const Clock::time_point now = Clock::now();
  std::shared_ptr<SimulatorConnection> replaced;
  std::optional<SimulatorSession> session;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    const bool known = simulators_.count(announcement.name) > 0;
    if (closing_ || (!known && simulators_.size() >= MOST_SIMULATORS))
    {
      return std::nullopt;
    }
    SimulatorRecord& simulator = simulators_[announcement.name];
    const bool another = known && !sameProcess(simulator.announcement, announcement);
    if (another && simulator.served())
    {
      replaced = lose(simulator, "another process announced itself under its name");
    }
    else if (another && simulator.rejected())
    {
      simulator.state = WorkerState::LOST;
    }
    simulator.announcement = announcement;
    simulator.last_heard = now;
    if (mayBeCalled(simulator, now))
    {
      session = openSession(simulator, connector);
    }
  }
  abort({ replaced });
  return session;
}

SimulatorSession SimulatorFarm::State::openSession(SimulatorRecord& simulator, const SimulatorConnector& connector)
{
  if (!simulator.rejected())
  {
    greet(simulator);
  }
  simulator.session = ++sessions_;
  simulator.connection = connector(simulator.announcement);
  simulator.call_began = Clock::now();
  simulator.told = true;  // unless the call fails
  ++threads_;
  return { simulator.name(), simulator.session, simulator.connection,
           simulator.state == WorkerState::QUARANTINED ? simulator.reason : "" };
}

void SimulatorFarm::State::greet(SimulatorRecord& simulator)
{
  simulator.state = WorkerState::CONNECTING;
  if (fingerprintFor(body_->kind(), simulator.announcement) != settings_.engine_fingerprint)
  {
    simulator.state = WorkerState::REFUSED;
    simulator.reason = engineMismatch(simulator.announcement, body_->kind(), settings_.engine_fingerprint);
    ROS_ERROR_STREAM("refused " << describe(simulator.announcement) << ": " << simulator.reason);
  }
}

bool SimulatorFarm::State::mayBeCalled(const SimulatorRecord& simulator, Clock::time_point now)
{
  return (simulator.state == WorkerState::LOST || (simulator.rejected() && !simulator.told)) &&
         now >= simulator.retry_at;
}

void SimulatorFarm::State::serve(const SimulatorSession& session)
{
  try
  {
    if (const std::optional<std::string> failure = work(session))
    {
      fail(session, *failure);
    }
  }
  catch (const InvalidInput& e)
  {
    answeredNonsense(session, e.what());
  }
  catch (const std::exception& e)
  {
    fail(session, e.what());
  }
  threadEnded();
}

std::optional<std::string> SimulatorFarm::State::work(const SimulatorSession& session)
{
  const std::string broken = "the connection failed";
  // Asking for nothing first shows that the connection works, and tells a simulator that is refused or quarantined so.
  if (!ask(*session.connection, {}, session.quarantine))
  {
    return broken;
  }
  if (!connected(session))
  {
    return std::nullopt;
  }
  for (auto batch = take(session); !batch.empty(); batch = take(session))
  {
    const auto evaluations = ask(*session.connection, batch);
    if (!evaluations)
    {
      return broken;
    }
    deliver(session, *evaluations);
  }
  return std::nullopt;
}

void SimulatorFarm::State::abandon(const SimulatorSession& session, const std::string& reason)
{
  fail(session, reason);
  threadEnded();
}

std::optional<std::vector<Evaluation>> SimulatorFarm::State::ask(SimulatorConnection& connection,
                                                                 const std::vector<EvaluationRequest>& robots,
                                                                 const std::string& quarantine) const
{
  EvaluateGenomes::Request request = toRequest(robots, settings_.body, *body_, settings_.engine_fingerprint);
  request.quarantine = quarantine;
  EvaluateGenomes::Response response;
  if (!connection.call(request, response))
  {
    return std::nullopt;
  }
  return evaluationsOf(response, robots, *body_);
}

bool SimulatorFarm::State::connected(const SimulatorSession& session)
{
  std::lock_guard<std::mutex> lock(mutex_);
  SimulatorRecord* const simulator = find(session);
  if (simulator == nullptr)
  {
    return false;
  }
  if (simulator->rejected())
  {
    endSession(*simulator);
    return false;
  }
  simulator->call_began.reset();
  ROS_INFO_STREAM(describe(simulator->announcement) << (simulator->losses == 0 ? " joined" : " is back"));
  simulator->state = WorkerState::IDLE;
  return true;
}

std::vector<EvaluationRequest> SimulatorFarm::State::take(const SimulatorSession& session)
{
  std::unique_lock<std::mutex> lock(mutex_);
  while (find(session) != nullptr && !ledger_.hasWorkFor(session.simulator))
  {
    referChecks();
    work_changed_.wait(lock);
  }
  SimulatorRecord* const simulator = find(session);
  if (simulator == nullptr)
  {
    return {};
  }
  std::vector<EvaluationRequest> batch = ledger_.take(session.simulator, batchSize(*simulator));
  simulator->state = WorkerState::WORKING;
  simulator->call_began = Clock::now();
  return batch;
}

void SimulatorFarm::State::deliver(const SimulatorSession& session, const std::vector<Evaluation>& evaluations)
{
  Connections liars;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    SimulatorRecord* const simulator = find(session);
    if (simulator == nullptr)
    {
      return;  // too late: its robots have been given to others
    }
    const BatchTimes::Seconds time = Clock::now() - *simulator->call_began;
    batch_times_.add(time);
    if (simulator->state == WorkerState::LATE)
    {
      ROS_INFO_STREAM(describe(simulator->announcement)
                      << " has answered after " << fixedText(time.count(), 1) << " s");
    }
    ledger_.deliver(session.simulator, evaluations);
    simulator->evaluations += static_cast<int64_t>(evaluations.size());
    simulator->call_began.reset();
    simulator->state = WorkerState::IDLE;
    simulator->failures = 0;
    liars = actOnComparisons();
  }
  abort(liars);
}

/// Who answers nonsense once may have done so before, where it could not be seen.
void SimulatorFarm::State::answeredNonsense(const SimulatorSession& session, const std::string& what)
{
  std::lock_guard<std::mutex> lock(mutex_);
  SimulatorRecord* const simulator = find(session);
  if (simulator == nullptr)
  {
    return;
  }
  if (simulator->rejected())
  {
    endSession(*simulator);  // it has been told, whatever it says to that
    return;
  }
  lose(*simulator, what);
  const size_t voided = ledger_.distrust(session.simulator);
  if (voided > 0)
  {
    ROS_WARN_STREAM("evaluating again what " << describe(simulator->announcement)
                                             << " answered before in generations that are not committed: "
                                             << toText(static_cast<int64_t>(voided)) << " robots");
  }
  work_changed_.notify_all();
}

void SimulatorFarm::State::fail(const SimulatorSession& session, const std::string& reason)
{
  std::lock_guard<std::mutex> lock(mutex_);
  SimulatorRecord* const simulator = find(session);
  if (simulator == nullptr)
  {
    return;
  }
  if (simulator->rejected())
  {
    tellAgain(*simulator);
    return;
  }
  lose(*simulator, reason);
}

/// It may not know yet that it is rejected: when it announces itself next.
void SimulatorFarm::State::tellAgain(SimulatorRecord& simulator)
{
  simulator.told = false;
  putOff(simulator);
  endSession(simulator);
}

void SimulatorFarm::State::threadEnded()
{
  std::lock_guard<std::mutex> lock(mutex_);
  --threads_;
  threads_changed_.notify_all();
}

std::shared_ptr<SimulatorConnection> SimulatorFarm::State::lose(SimulatorRecord& simulator, const std::string& reason)
{
  const size_t robots = ledger_.giveUp(simulator.name());
  ROS_WARN_STREAM(
      "lost " << describe(simulator.announcement) << ": " << reason
              << (robots == 0 ? "" : "; its batch of " + toText(static_cast<int64_t>(robots)) + " goes to others"));
  simulator.state = WorkerState::LOST;
  simulator.reason = reason;
  putOff(simulator);
  ++simulator.losses;
  return endSession(simulator);
}

void SimulatorFarm::State::putOff(SimulatorRecord& simulator)
{
  constexpr std::chrono::duration<double> longest_retry_delay{ 60.0 };
  const auto delay = settings_.retry_delay * (1 << std::min(simulator.failures, 16));
  simulator.retry_at = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::min(delay, longest_retry_delay));
  ++simulator.failures;
}

std::shared_ptr<SimulatorConnection> SimulatorFarm::State::endSession(SimulatorRecord& simulator)
{
  simulator.call_began.reset();
  simulator.session = 0;
  work_changed_.notify_all();
  return std::move(simulator.connection);
}

SimulatorRecord* SimulatorFarm::State::find(const SimulatorSession& session)
{
  const auto entry = simulators_.find(session.simulator);
  const bool current = !closing_ && entry != simulators_.end() && entry->second.session == session.number;
  return current ? &entry->second : nullptr;
}

/// As many robots as it simulates in lock-step, since they take hardly longer than one; but no more than would leave
/// nothing for other simulators, if all robots of the generations under way were dealt out at once. (What waits just
/// now is no measure: with many trials it is little and soon more, and batches would become small for nothing.)
size_t SimulatorFarm::State::batchSize(const SimulatorRecord& simulator) const
{
  const auto usable = static_cast<size_t>(
      std::count_if(simulators_.begin(), simulators_.end(), [](const auto& entry) { return entry.second.usable(); }));
  const size_t share = (ledger_.open() + usable - 1) / usable;
  return std::min(share, static_cast<size_t>(simulator.announcement.lanes));
}

void SimulatorFarm::State::submit(std::vector<EvaluationRequest> requests)
{
  std::lock_guard<std::mutex> lock(mutex_);
  ledger_.submit(std::move(requests));
  work_changed_.notify_all();
}

std::vector<EvaluationResult> SimulatorFarm::State::collect(std::chrono::milliseconds timeout)
{
  std::unique_lock<std::mutex> lock(mutex_);
  results_changed_.wait_for(lock, timeout, [this] { return ledger_.hasResults() || error_; });
  if (error_)
  {
    std::rethrow_exception(error_);
  }
  return ledger_.takeResults();
}

std::vector<WorkerStatus> SimulatorFarm::State::status() const
{
  std::lock_guard<std::mutex> lock(mutex_);
  std::vector<WorkerStatus> workers;
  for (const auto& [name, simulator] : simulators_)
  {
    workers.push_back(simulator.status());
  }
  for (const auto& [host, status] : forgotten_)
  {
    workers.push_back(status);
  }
  return workers;
}

void SimulatorFarm::State::beginClosing()
{
  Connections connections;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    closing_ = true;
    for (const auto& [name, simulator] : simulators_)
    {
      connections.push_back(simulator.connection);
    }
    work_changed_.notify_all();
    closing_changed_.notify_all();
    disputes_changed_.notify_all();
  }
  abort(connections);
}

bool SimulatorFarm::State::waitForThreads()
{
  std::unique_lock<std::mutex> lock(mutex_);
  return threads_changed_.wait_for(lock, CLOSE_TIMEOUT, [this] { return threads_ == 0; });
}

void SimulatorFarm::State::abort(const Connections& connections)
{
  for (const std::shared_ptr<SimulatorConnection>& connection : connections)
  {
    if (connection)
    {
      connection->abort();
    }
  }
}
}  // namespace devo_evo
