#include "ros/simulator_farm.h"

#include "devo_evo/soft_body/text.h"
#include "ros/conversions.h"

#include <ros/console.h>

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <system_error>
#include <utility>

namespace devo_evo
{
namespace
{
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr Seconds WATCH_PERIOD{ 0.05 };
constexpr Seconds STALL{ 1.0 };           // a watchdog that wakes up this late was stopped itself
constexpr Seconds FORGET_AFTER{ 600.0 };  // a simulator of which nothing was heard for so long is not reported any more
constexpr Seconds LONGEST_RETRY_DELAY{ 60.0 };
constexpr Seconds CLOSE_TIMEOUT{ 2.0 };
constexpr size_t MOST_SIMULATORS = 4096;

enum class Phase
{
  CONNECTING,
  IDLE,
  WORKING,
  LOST,
  REFUSED
};

struct Simulator
{
  SimulatorAnnouncement announcement;  // the latest
  Phase phase = Phase::LOST;
  std::string reason;    // why LOST or REFUSED
  uint64_t session = 0;  // which thread serves it; what earlier ones still bring is void
  std::shared_ptr<SimulatorConnection> connection;
  std::vector<EvaluationRequest> batch;       // what it works on
  std::optional<Clock::time_point> deadline;  // of the call that runs
  Clock::time_point last_heard;
  Clock::time_point retry_at;  // no new session before
  int failures = 0;            // in a row
  int64_t evaluations = 0;

  bool usable() const { return phase == Phase::IDLE || phase == Phase::WORKING; }
  bool served() const { return usable() || phase == Phase::CONNECTING; }
};

/// What a thread needs to serve a simulator.
struct Session
{
  std::string simulator;
  uint64_t number;
  std::shared_ptr<SimulatorConnection> connection;
};

bool sameProcess(const SimulatorAnnouncement& a, const SimulatorAnnouncement& b)
{
  return a.service == b.service && a.host == b.host && a.pid == b.pid;
}

Clock::duration ticks(Seconds seconds)
{
  return std::chrono::duration_cast<Clock::duration>(seconds);
}

std::string describe(const SimulatorAnnouncement& simulator)
{
  return simulator.name + " (host " + simulator.host + ", process " + toText(static_cast<int64_t>(simulator.pid)) +
         ", " + simulator.instruction_set + ")";
}

std::string mismatch(const SimulatorAnnouncement& simulator, uint64_t own_fingerprint)
{
  return "its engine fingerprint is " + hashToString(simulator.engine_fingerprint) + ", that of this evolver is " +
         hashToString(own_fingerprint) + "; its version is " + simulator.version;
}

std::string stateText(const Simulator& simulator)
{
  switch (simulator.phase)
  {
    case Phase::CONNECTING:
      return "connecting";
    case Phase::IDLE:
      return "idle";
    case Phase::WORKING:
      return "working";
    case Phase::LOST:
      return "lost: " + simulator.reason;
    case Phase::REFUSED:
      return "refused: " + simulator.reason;
  }
  return "";
}

/// How much longer the lives of one batch take than those of the paper's robots, at least 1.
double relativeCost(const SoftBodySettings& body)
{
  const auto cost = [](const SoftBodySettings& settings)
  { return settings.voxelCount() * (SETTLING_TIME + settings.lifetime) / settings.timeStep(); };
  return std::max(1.0, cost(body) / cost(SoftBodySettings()));
}
}  // namespace

/// What the farm's owner, its watchdog and its simulators' threads share. Every function locks.
class SimulatorFarm::State
{
public:
  explicit State(const SimulatorFarmSettings& settings)
    : settings_(settings), call_timeout_(settings.batch_timeout * relativeCost(settings.body))
  {
  }

  const SimulatorFarmSettings& settings() const { return settings_; }

  std::optional<Session> announced(const SimulatorAnnouncement& announcement, const SimulatorConnector& connector);

  /// Serves one simulator until the session is over; returns at the end of its thread.
  void serve(const Session& session);

  /// Ends a session whose thread could not be started.
  void abandon(const Session& session, const std::string& reason);

  /// Gives up simulators that are late or silent, until the farm is closed.
  void watch();

  void submit(std::vector<EvaluationRequest> requests);
  std::vector<EvaluationResult> collect(std::chrono::milliseconds timeout);
  std::vector<WorkerStatus> status() const;
  void beginClosing();
  bool waitForThreads();

private:
  /// One call. @throw InvalidInput if it fails or its answer will not do.
  std::vector<Evaluation> ask(SimulatorConnection& connection, const std::vector<EvaluationRequest>& robots) const;

  /// The first call was answered. @return whether the simulator gets work.
  bool connected(const Session& session);

  /// Waits for work. Nothing: the session is over.
  std::vector<EvaluationRequest> take(const Session& session);
  void deliver(const Session& session, const std::vector<Evaluation>& evaluations);
  void fail(const Session& session, const std::string& reason);
  void threadEnded();

  /// The simulator, if it is still served by this session.
  Simulator* find(const Session& session);
  Seconds silenceTimeout(const Simulator& simulator) const;
  size_t batchSize(const Simulator& simulator) const;
  std::shared_ptr<SimulatorConnection> lose(Simulator& simulator, const std::string& reason);
  std::shared_ptr<SimulatorConnection> check(Simulator& simulator, Clock::time_point now);
  void forgive(Clock::duration stall);
  Session openSession(Simulator& simulator, const SimulatorConnector& connector);

  const SimulatorFarmSettings settings_;
  const Seconds call_timeout_;

  mutable std::mutex mutex_;
  std::condition_variable work_changed_;
  std::condition_variable results_changed_;
  std::condition_variable threads_changed_;
  std::condition_variable closing_changed_;
  std::deque<EvaluationRequest> pending_;
  std::vector<EvaluationResult> results_;
  std::map<std::string, Simulator> simulators_;  // by name
  uint64_t sessions_ = 0;
  int threads_ = 0;
  bool closing_ = false;
};

std::optional<Session> SimulatorFarm::State::announced(const SimulatorAnnouncement& announcement,
                                                       const SimulatorConnector& connector)
{
  const Clock::time_point now = Clock::now();
  std::shared_ptr<SimulatorConnection> replaced;  // aborted below, without the lock
  std::optional<Session> session;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    if (closing_ || (simulators_.count(announcement.name) == 0 && simulators_.size() >= MOST_SIMULATORS))
    {
      return std::nullopt;
    }
    const bool known = simulators_.count(announcement.name) > 0;
    Simulator& simulator = simulators_[announcement.name];
    if (known && !sameProcess(simulator.announcement, announcement) && simulator.served())
    {
      replaced = lose(simulator, "another process announced itself under its name");
    }
    simulator.announcement = announcement;
    simulator.last_heard = now;
    if (simulator.phase == Phase::LOST && now >= simulator.retry_at)
    {
      session = openSession(simulator, connector);
    }
  }
  if (replaced)
  {
    replaced->abort();
  }
  return session;
}

Session SimulatorFarm::State::openSession(Simulator& simulator, const SimulatorConnector& connector)
{
  const SimulatorAnnouncement& announcement = simulator.announcement;
  simulator.phase = Phase::CONNECTING;
  if (announcement.engine_fingerprint != settings_.engine_fingerprint)
  {
    simulator.phase = Phase::REFUSED;
    simulator.reason = mismatch(announcement, settings_.engine_fingerprint);
    ROS_ERROR_STREAM("refused " << describe(announcement) << ": " << simulator.reason);
  }
  simulator.session = ++sessions_;
  simulator.connection = connector(announcement);
  simulator.deadline = Clock::now() + ticks(call_timeout_);
  ++threads_;
  return { announcement.name, simulator.session, simulator.connection };
}

void SimulatorFarm::State::serve(const Session& session)
{
  try
  {
    // Asking for nothing first shows that the connection works, and tells a simulator that is refused so.
    ask(*session.connection, {});
    if (connected(session))
    {
      for (auto batch = take(session); !batch.empty(); batch = take(session))
      {
        deliver(session, ask(*session.connection, batch));
      }
    }
  }
  catch (const std::exception& e)
  {
    fail(session, e.what());
  }
  threadEnded();
}

void SimulatorFarm::State::abandon(const Session& session, const std::string& reason)
{
  fail(session, reason);
  threadEnded();
}

std::vector<Evaluation> SimulatorFarm::State::ask(SimulatorConnection& connection,
                                                  const std::vector<EvaluationRequest>& robots) const
{
  EvaluateGenomes::Response response;
  if (!connection.call(toRequest(robots, settings_.body, settings_.engine_fingerprint), response))
  {
    throw InvalidInput("the connection failed");
  }
  return evaluationsOf(response, robots, settings_.body);
}

bool SimulatorFarm::State::connected(const Session& session)
{
  std::lock_guard<std::mutex> lock(mutex_);
  Simulator* const simulator = find(session);
  if (simulator == nullptr)
  {
    return false;
  }
  simulator->deadline.reset();
  if (simulator->phase == Phase::REFUSED)
  {
    return false;
  }
  ROS_INFO_STREAM(describe(simulator->announcement) << (simulator->reason.empty() ? " joined" : " is back"));
  simulator->phase = Phase::IDLE;
  return true;
}

std::vector<EvaluationRequest> SimulatorFarm::State::take(const Session& session)
{
  std::unique_lock<std::mutex> lock(mutex_);
  work_changed_.wait(lock, [&] { return find(session) == nullptr || !pending_.empty(); });
  Simulator* const simulator = find(session);
  if (simulator == nullptr)
  {
    return {};
  }
  const auto end = pending_.begin() + static_cast<std::ptrdiff_t>(batchSize(*simulator));
  simulator->batch.assign(std::make_move_iterator(pending_.begin()), std::make_move_iterator(end));
  pending_.erase(pending_.begin(), end);
  simulator->phase = Phase::WORKING;
  simulator->deadline = Clock::now() + ticks(call_timeout_);
  return simulator->batch;
}

void SimulatorFarm::State::deliver(const Session& session, const std::vector<Evaluation>& evaluations)
{
  std::lock_guard<std::mutex> lock(mutex_);
  Simulator* const simulator = find(session);
  if (simulator == nullptr)
  {
    return;  // too late: its robots have been given to others
  }
  for (size_t i = 0; i < evaluations.size(); ++i)
  {
    const EvaluationRequest& robot = simulator->batch[i];
    results_.push_back({ robot.trial, robot.id, evaluations[i], session.simulator });
  }
  simulator->evaluations += static_cast<int64_t>(evaluations.size());
  simulator->batch.clear();
  simulator->deadline.reset();
  simulator->phase = Phase::IDLE;
  simulator->failures = 0;
  results_changed_.notify_all();
}

void SimulatorFarm::State::fail(const Session& session, const std::string& reason)
{
  std::lock_guard<std::mutex> lock(mutex_);
  Simulator* const simulator = find(session);
  if (simulator == nullptr)
  {
    return;
  }
  if (simulator->phase == Phase::REFUSED)
  {
    simulator->deadline.reset();
    return;
  }
  lose(*simulator, reason);
}

void SimulatorFarm::State::threadEnded()
{
  std::lock_guard<std::mutex> lock(mutex_);
  --threads_;
  threads_changed_.notify_all();
}

void SimulatorFarm::State::watch()
{
  std::unique_lock<std::mutex> lock(mutex_);
  Clock::time_point last_check = Clock::now();
  while (!closing_changed_.wait_for(lock, WATCH_PERIOD, [this] { return closing_; }))
  {
    const Clock::time_point now = Clock::now();
    if (now - last_check > STALL)
    {
      forgive(now - last_check);
    }
    last_check = now;
    std::vector<std::shared_ptr<SimulatorConnection>> late;
    for (auto entry = simulators_.begin(); entry != simulators_.end();)
    {
      late.push_back(check(entry->second, now));
      const bool forgotten = !entry->second.served() && now - entry->second.last_heard > FORGET_AFTER;
      entry = forgotten ? simulators_.erase(entry) : std::next(entry);
    }
    lock.unlock();
    for (const std::shared_ptr<SimulatorConnection>& connection : late)
    {
      if (connection)
      {
        connection->abort();
      }
    }
    lock.lock();
  }
}

std::shared_ptr<SimulatorConnection> SimulatorFarm::State::check(Simulator& simulator, Clock::time_point now)
{
  const bool late = simulator.deadline && now > *simulator.deadline;
  if (late && simulator.phase == Phase::REFUSED)
  {
    simulator.deadline.reset();
    return simulator.connection;
  }
  if (late)
  {
    return lose(simulator, "no answer within " + toText(call_timeout_.count()) + " s");
  }
  const Seconds silence = now - simulator.last_heard;
  if (simulator.served() && silence > silenceTimeout(simulator))
  {
    return lose(simulator, "no sign of life for " + toText(silenceTimeout(simulator).count()) + " s");
  }
  return nullptr;
}

/// Time in which this process did not run counts against nobody.
void SimulatorFarm::State::forgive(Clock::duration stall)
{
  for (auto& [name, simulator] : simulators_)
  {
    simulator.last_heard += stall;
    if (simulator.deadline)
    {
      *simulator.deadline += stall;
    }
  }
}

std::shared_ptr<SimulatorConnection> SimulatorFarm::State::lose(Simulator& simulator, const std::string& reason)
{
  std::string consequence;
  if (!simulator.batch.empty())
  {
    consequence = "; its batch of " + toText(static_cast<int64_t>(simulator.batch.size())) + " goes to others";
  }
  ROS_WARN_STREAM("lost " << describe(simulator.announcement) << ": " << reason << consequence);
  pending_.insert(pending_.begin(), std::make_move_iterator(simulator.batch.begin()),
                  std::make_move_iterator(simulator.batch.end()));
  simulator.batch.clear();
  simulator.deadline.reset();
  simulator.phase = Phase::LOST;
  simulator.reason = reason;
  simulator.session = 0;
  const Seconds delay = settings_.retry_delay * (1 << std::min(simulator.failures, 16));
  simulator.retry_at = Clock::now() + ticks(std::min(delay, LONGEST_RETRY_DELAY));
  ++simulator.failures;
  work_changed_.notify_all();
  return std::move(simulator.connection);
}

Simulator* SimulatorFarm::State::find(const Session& session)
{
  const auto entry = simulators_.find(session.simulator);
  const bool current = !closing_ && entry != simulators_.end() && entry->second.session == session.number;
  return current ? &entry->second : nullptr;
}

Seconds SimulatorFarm::State::silenceTimeout(const Simulator& simulator) const
{
  return std::max(settings_.silence_timeout, Seconds(10.0 * simulator.announcement.period));
}

/// As many robots as it simulates in lock-step, since they take hardly longer than one; but leaving some to every other
/// simulator that has nothing to do.
size_t SimulatorFarm::State::batchSize(const Simulator& simulator) const
{
  const auto idle = static_cast<size_t>(std::count_if(
      simulators_.begin(), simulators_.end(), [](const auto& entry) { return entry.second.phase == Phase::IDLE; }));
  const size_t share = (pending_.size() + idle - 1) / idle;
  return std::min(share, static_cast<size_t>(simulator.announcement.lanes));
}

void SimulatorFarm::State::submit(std::vector<EvaluationRequest> requests)
{
  std::lock_guard<std::mutex> lock(mutex_);
  pending_.insert(pending_.end(), std::make_move_iterator(requests.begin()), std::make_move_iterator(requests.end()));
  work_changed_.notify_all();
}

std::vector<EvaluationResult> SimulatorFarm::State::collect(std::chrono::milliseconds timeout)
{
  std::unique_lock<std::mutex> lock(mutex_);
  results_changed_.wait_for(lock, timeout, [this] { return !results_.empty(); });
  return std::exchange(results_, {});
}

std::vector<WorkerStatus> SimulatorFarm::State::status() const
{
  std::lock_guard<std::mutex> lock(mutex_);
  std::vector<WorkerStatus> workers;
  for (const auto& [name, simulator] : simulators_)
  {
    workers.push_back({ name, stateText(simulator), simulator.usable(), simulator.evaluations });
  }
  return workers;
}

void SimulatorFarm::State::beginClosing()
{
  std::vector<std::shared_ptr<SimulatorConnection>> connections;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    closing_ = true;
    for (const auto& [name, simulator] : simulators_)
    {
      connections.push_back(simulator.connection);
    }
    work_changed_.notify_all();
    closing_changed_.notify_all();
  }
  for (const std::shared_ptr<SimulatorConnection>& connection : connections)
  {
    if (connection)
    {
      connection->abort();
    }
  }
}

bool SimulatorFarm::State::waitForThreads()
{
  std::unique_lock<std::mutex> lock(mutex_);
  return threads_changed_.wait_for(lock, CLOSE_TIMEOUT, [this] { return threads_ == 0; });
}

SimulatorFarm::SimulatorFarm(const SimulatorFarmSettings& settings, SimulatorConnector connector)
  : connector_(std::move(connector))
  , state_(std::make_shared<State>(settings))
  , watchdog_([state = state_] { state->watch(); })
{
}

SimulatorFarm::~SimulatorFarm()
{
  close();
}

bool SimulatorFarm::close()
{
  state_->beginClosing();
  if (watchdog_.joinable())
  {
    watchdog_.join();
  }
  return state_->waitForThreads();
}

void SimulatorFarm::heardFrom(const SimulatorAnnouncement& announcement)
{
  const std::optional<Session> session = state_->announced(announcement, connector_);
  if (!session)
  {
    return;
  }
  try
  {
    std::thread([state = state_, session = *session] { state->serve(session); }).detach();
  }
  catch (const std::system_error& e)
  {
    state_->abandon(*session, std::string("no thread for it: ") + e.what());
  }
}

void SimulatorFarm::submit(std::vector<EvaluationRequest> requests)
{
  for (const EvaluationRequest& request : requests)
  {
    validate(request.program, state_->settings().body);
  }
  state_->submit(std::move(requests));
}

std::vector<EvaluationResult> SimulatorFarm::collect(std::chrono::milliseconds timeout)
{
  return state_->collect(timeout);
}

std::vector<WorkerStatus> SimulatorFarm::status() const
{
  return state_->status();
}
}  // namespace devo_evo
