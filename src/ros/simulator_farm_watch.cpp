#include "ros/simulator_farm_state.h"

#include "devo_evo/experiment/report_text.h"
#include "devo_evo/soft_body/simulation.h"
#include "devo_evo/soft_body/text.h"

#include <ros/console.h>

#include <algorithm>
#include <set>
#include <utility>

namespace devo_evo
{
namespace
{
using Seconds = std::chrono::duration<double>;

constexpr std::chrono::milliseconds WATCH_PERIOD{ 50 };
constexpr Seconds STALL{ 1.0 };           // a watchdog that wakes up this late was stopped itself
constexpr Seconds FORGET_AFTER{ 600.0 };  // a simulator of which nothing was heard for so long has no entry of its own
constexpr double LATE_FACTOR = 10.0;      // over the usual time of a batch
constexpr size_t MOST_HOSTS = 1024;

std::string outcomeText(const Evaluation& evaluation)
{
  return evaluation.valid
             ? "state hash " + hashToString(evaluation.state_hash) + " and fitness " + toText(evaluation.fitness)
             : "divergence";
}
}  // namespace

void SimulatorFarm::State::watch()
{
  std::unique_lock<std::mutex> lock(mutex_);
  Clock::time_point last_check = Clock::now();
  while (!closing_changed_.wait_for(lock, WATCH_PERIOD, [this] { return closing_.load(); }))
  {
    const Clock::time_point now = Clock::now();
    if (now - last_check > STALL)
    {
      forgive(now - last_check);
    }
    last_check = now;
    const Connections given_up = checkAll(now);
    lock.unlock();
    abort(given_up);
    lock.lock();
  }
}

SimulatorFarm::State::Connections SimulatorFarm::State::checkAll(Clock::time_point now)
{
  Connections given_up;
  for (auto& [name, simulator] : simulators_)
  {
    given_up.push_back(check(simulator, now));
  }
  forgetOld(now);
  referChecks();
  return given_up;
}

std::shared_ptr<SimulatorConnection> SimulatorFarm::State::check(SimulatorRecord& simulator, Clock::time_point now)
{
  const bool overdue = simulator.call_began && now - *simulator.call_began > call_timeout_;
  if (overdue && simulator.rejected())
  {
    simulator.call_began.reset();
    return simulator.connection;
  }
  if (overdue)
  {
    return lose(simulator, "no answer within " + toText(call_timeout_.count()) + " s");
  }
  const Seconds silence = now - simulator.last_heard;
  if (simulator.served() && silence > silenceTimeout(simulator))
  {
    return lose(simulator, "no sign of life for " + toText(silenceTimeout(simulator).count()) + " s");
  }
  const std::optional<std::string> lateness = this->lateness(simulator, now);
  if (simulator.state == WorkerState::WORKING && lateness)
  {
    callLate(simulator, *lateness);
  }
  else if (simulator.state == WorkerState::LATE && ledger_.isSuperseded(simulator.name()))
  {
    return lose(simulator, "others have done its batch meanwhile; " + lateness.value_or(simulator.reason));
  }
  return nullptr;
}

/// Why a working simulator counts as late: half the time of silence that is allowed, or much more time for a batch than
/// usual.
std::optional<std::string> SimulatorFarm::State::lateness(const SimulatorRecord& simulator, Clock::time_point now) const
{
  const Seconds silence = now - simulator.last_heard;
  if (silence > 0.5 * silenceTimeout(simulator))
  {
    return "no sign of life for " + fixedText(silence.count(), 1) + " s";
  }
  const std::optional<Seconds> usual = batch_times_.usual();
  if (!usual || !simulator.call_began)
  {
    return std::nullopt;
  }
  const Seconds time = now - *simulator.call_began;
  if (time <= std::max(settings_.shortest_lateness, LATE_FACTOR * *usual))
  {
    return std::nullopt;
  }
  return "no answer for " + fixedText(time.count(), 1) + " s, where " + fixedText(usual->count(), 2) + " s are usual";
}

void SimulatorFarm::State::callLate(SimulatorRecord& simulator, const std::string& reason)
{
  ROS_WARN_STREAM("late: " << describe(simulator.announcement) << ": " << reason << "; others do its batch too");
  simulator.state = WorkerState::LATE;
  simulator.reason = reason;
  ledger_.doAgain(simulator.name());
  work_changed_.notify_all();
}

Seconds SimulatorFarm::State::silenceTimeout(const SimulatorRecord& simulator) const
{
  return std::max(settings_.silence_timeout, Seconds(10.0 * simulator.announcement.period));
}

/// Time in which this process did not run counts against nobody.
void SimulatorFarm::State::forgive(Clock::duration stall)
{
  for (auto& [name, simulator] : simulators_)
  {
    simulator.last_heard += stall;
    if (simulator.call_began)
    {
      *simulator.call_began += stall;
    }
  }
}

/// Simulators of which nothing is heard any more are kept as one entry per host.
void SimulatorFarm::State::forgetOld(Clock::time_point now)
{
  for (auto entry = simulators_.begin(); entry != simulators_.end();)
  {
    const SimulatorRecord& simulator = entry->second;
    if (simulator.served() || now - simulator.last_heard <= FORGET_AFTER)
    {
      ++entry;
      continue;
    }
    const std::string& own_host = simulator.announcement.host;
    const bool full = forgotten_.size() >= MOST_HOSTS && forgotten_.count(own_host) == 0;
    const std::string host = full ? "others" : own_host;
    WorkerStatus& status = forgotten_[host];
    status.name = "earlier simulators of " + host;
    status.host = host;
    status.state = WorkerState::LOST;
    status.reason = "not heard of for ten minutes";
    status.evaluations += simulator.evaluations;
    status.checked += simulator.checked;
    status.losses += simulator.losses;
    entry = simulators_.erase(entry);
  }
}

void SimulatorFarm::State::referChecks()
{
  if (ledger_.waiting() == 0)
  {
    return;
  }
  std::set<std::string> usable;
  for (const auto& [name, simulator] : simulators_)
  {
    if (simulator.usable())
    {
      usable.insert(name);
    }
  }
  ledger_.refer(usable);
  if (ledger_.hasWorkForReferee())
  {
    disputes_changed_.notify_all();
  }
}

void SimulatorFarm::State::judgeDisputes()
{
  std::unique_lock<std::mutex> lock(mutex_);
  try
  {
    for (;;)
    {
      disputes_changed_.wait(lock, [this] { return closing_ || ledger_.hasWorkForReferee(); });
      if (closing_)
      {
        return;
      }
      const auto [number, request] = ledger_.takeAsReferee();
      lock.unlock();
      const Evaluation evaluation = referee_(request.program, closing_);
      lock.lock();
      ledger_.judge(number, evaluation);
      const Connections liars = actOnComparisons();
      lock.unlock();
      abort(liars);
      lock.lock();
    }
  }
  catch (const EvaluationAbandoned&)
  {
    // The farm is being closed.
  }
  catch (...)
  {
    if (!lock.owns_lock())
    {
      lock.lock();
    }
    error_ = std::current_exception();
    results_changed_.notify_all();
  }
}

SimulatorFarm::State::Connections SimulatorFarm::State::actOnComparisons()
{
  Connections liars;
  for (const Comparison& comparison : ledger_.takeComparisons())
  {
    const auto entry = simulators_.find(comparison.worker);
    if (entry == simulators_.end())
    {
      continue;
    }
    SimulatorRecord& simulator = entry->second;
    if (comparison.agrees)
    {
      ++simulator.checked;
    }
    else if (simulator.state != WorkerState::QUARANTINED)
    {
      liars.push_back(quarantine(simulator, comparison));
    }
  }
  if (ledger_.hasWorkForReferee())
  {
    disputes_changed_.notify_all();
  }
  if (ledger_.hasResults())
  {
    results_changed_.notify_all();
  }
  return liars;
}

std::shared_ptr<SimulatorConnection> SimulatorFarm::State::quarantine(SimulatorRecord& simulator,
                                                                      const Comparison& comparison)
{
  const size_t voided = ledger_.distrust(simulator.name());
  simulator.state = WorkerState::QUARANTINED;
  simulator.told = false;
  simulator.reason = "its evaluation of robot " + individualName(comparison.trial, comparison.id) + " has " +
                     outcomeText(comparison.given) + ", that of the evolver has " + outcomeText(comparison.right);
  ROS_ERROR_STREAM("quarantined " << describe(simulator.announcement) << ": " << simulator.reason << "; "
                                  << toText(static_cast<int64_t>(voided))
                                  << " other evaluations of it, in generations that are not committed, are made again. "
                                     "Look at the memory and the processor of host "
                                  << simulator.announcement.host);
  return endSession(simulator);
}
}  // namespace devo_evo
