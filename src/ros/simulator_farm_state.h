#pragma once

#include "farm/batch_times.h"
#include "farm/work_ledger.h"
#include "ros/simulator_farm.h"
#include "ros/simulator_record.h"

#include <atomic>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace devo_evo
{
/// What a thread needs to serve a simulator.
struct SimulatorSession
{
  std::string simulator;
  uint64_t number;
  std::shared_ptr<SimulatorConnection> connection;
  std::string quarantine;  ///< why it is quarantined, which is all that there is to say to it; empty: it is not
};

/// What the farm's owner, its watchdog, its referee and its simulators' threads share. Every public function locks.
class SimulatorFarm::State
{
public:
  State(const SimulatorFarmSettings& settings, Referee referee);

  const Body& body() const { return *body_; }

  // ---- simulator_farm_state.cpp: simulators and the threads that serve them

  /// @return a session that a thread is to serve().
  std::optional<SimulatorSession> announced(const SimulatorAnnouncement& announcement,
                                            const SimulatorConnector& connector);

  /// Serves one simulator until the session is over; returns at the end of its thread.
  void serve(const SimulatorSession& session);

  /// Ends a session whose thread could not be started.
  void abandon(const SimulatorSession& session, const std::string& reason);

  void submit(std::vector<EvaluationRequest> requests);
  std::vector<EvaluationResult> collect(std::chrono::milliseconds timeout);
  std::vector<WorkerStatus> status() const;
  void beginClosing();
  bool waitForThreads();

  // ---- simulator_farm_watch.cpp: threads of the farm itself

  /// Gives up simulators that are late or silent, until the farm is closed.
  void watch();

  /// Evaluates what evaluations disagree on, until the farm is closed.
  void judgeDisputes();

private:
  using Clock = SimulatorRecord::Clock;
  using Connections = std::vector<std::shared_ptr<SimulatorConnection>>;

  /// One call. @throw InvalidInput if its answer will not do. @return nothing if there was none.
  std::optional<std::vector<Evaluation>> ask(SimulatorConnection& connection,
                                             const std::vector<EvaluationRequest>& robots,
                                             const std::string& quarantine = "") const;

  /// Whether something is to be asked of it, or told to it.
  static bool mayBeCalled(const SimulatorRecord& simulator, Clock::time_point now);
  SimulatorSession openSession(SimulatorRecord& simulator, const SimulatorConnector& connector);
  void greet(SimulatorRecord& simulator);

  /// Makes calls until one fails or the session is over. @return why a call failed; nothing if the session is over.
  std::optional<std::string> work(const SimulatorSession& session);

  /// The first call was answered. @return whether the simulator gets work.
  bool connected(const SimulatorSession& session);

  /// Waits for work. Nothing: the session is over.
  std::vector<EvaluationRequest> take(const SimulatorSession& session);
  void deliver(const SimulatorSession& session, const std::vector<Evaluation>& evaluations);
  void answeredNonsense(const SimulatorSession& session, const std::string& what);
  void fail(const SimulatorSession& session, const std::string& reason);
  void tellAgain(SimulatorRecord& simulator);
  void threadEnded();

  /// The simulator, if it is still served by this session.
  SimulatorRecord* find(const SimulatorSession& session);
  size_t batchSize(const SimulatorRecord& simulator) const;
  void referChecks();
  static void abort(const Connections& connections);

  /// Ends the simulator's session. Its connection is for the caller to abort, without the lock.
  std::shared_ptr<SimulatorConnection> lose(SimulatorRecord& simulator, const std::string& reason);
  std::shared_ptr<SimulatorConnection> endSession(SimulatorRecord& simulator);

  /// After another failure: no new session for a while.
  void putOff(SimulatorRecord& simulator);

  Connections checkAll(Clock::time_point now);
  std::shared_ptr<SimulatorConnection> check(SimulatorRecord& simulator, Clock::time_point now);
  void callLate(SimulatorRecord& simulator, const std::string& reason);
  std::optional<std::string> lateness(const SimulatorRecord& simulator, Clock::time_point now) const;
  std::chrono::duration<double> silenceTimeout(const SimulatorRecord& simulator) const;
  void forgive(Clock::duration stall);
  void forgetOld(Clock::time_point now);

  /// Draws the consequences of what has been compared.
  Connections actOnComparisons();
  std::shared_ptr<SimulatorConnection> quarantine(SimulatorRecord& simulator, const Comparison& comparison);

  const SimulatorFarmSettings settings_;
  const std::shared_ptr<const Body> body_;
  const Referee referee_;
  const std::chrono::duration<double> call_timeout_;
  std::atomic<bool> closing_{ false };  // set under the mutex

  mutable std::mutex mutex_;
  std::condition_variable work_changed_;
  std::condition_variable results_changed_;
  std::condition_variable threads_changed_;
  std::condition_variable closing_changed_;
  std::condition_variable disputes_changed_;
  WorkLedger ledger_;
  BatchTimes batch_times_;
  std::map<std::string, SimulatorRecord> simulators_;  // by name
  std::map<std::string, WorkerStatus> forgotten_;      // by host
  std::exception_ptr error_;
  uint64_t sessions_ = 0;
  int threads_ = 0;
};
}  // namespace devo_evo
