#pragma once

#include "devo_evo/bodies/bodies.h"
#include "devo_evo/farm/farm.h"

#include <devo_evo/EvaluateGenomes.h>
#include <devo_evo/SimulatorAnnouncement.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace devo_evo
{
/// A way to ask one simulator. Used for one call at a time, and never again after one has failed.
class SimulatorConnection
{
public:
  virtual ~SimulatorConnection() = default;

  /// Sends a request and waits for the answer, for ever if need be.
  /// @return false if no answer came and none will. @throw InvalidInput if what came is none.
  virtual bool call(const EvaluateGenomes::Request& request, EvaluateGenomes::Response& response) = 0;

  /// Makes a call() that waits return false soon, where that is possible. From any thread.
  virtual void abort() = 0;
};

/// Makes the connection to a simulator that announced itself. Must not block.
using SimulatorConnector = std::function<std::shared_ptr<SimulatorConnection>(const SimulatorAnnouncement&)>;

/// Evaluates a robot in this process. @param stop once true, it may throw EvaluationAbandoned.
using Referee = std::function<Evaluation(const DevelopmentalProgram&, const std::atomic<bool>& stop)>;

struct SimulatorFarmSettings
{
  BodySettings body;
  uint64_t engine_fingerprint = 0;  ///< for this kind of body; simulators with another one are refused

  /// How long a simulator may take for a batch of robots of the paper's body and lifetime; more for larger bodies and
  /// longer lives, in proportion.
  std::chrono::duration<double> batch_timeout{ 60.0 };

  /// After how long without an announcement a simulator counts as lost; at least ten announcement periods.
  std::chrono::duration<double> silence_timeout{ 5.0 };

  /// For how long a simulator that failed gets no work; doubles with every further failure in a row, up to a minute.
  std::chrono::duration<double> retry_delay{ 1.0 };

  /// A simulator that takes ten times as long for a batch as is usual in the farm, and at least this, is late: others
  /// are given its batch too.
  std::chrono::duration<double> shortest_lateness{ 2.0 };

  /// Of robots that are evaluated twice, on different simulators, 0 to 1.
  double checked_fraction = 0.0;
};

/// A farm of simulators that come, go and fail as they like. What it hears of them comes in by heardFrom(); how they
/// are asked is the connector's business, so that this class knows nothing of the network.
///
/// Each simulator has a thread that makes its calls, one at a time. A watchdog aborts calls that take too long and
/// gives silent simulators up; their robots go to others. A call that cannot even be aborted costs its thread, which is
/// left behind: threads share the state, so the farm itself goes on, and ends, without them.
class SimulatorFarm : public Farm
{
public:
  /// @param referee used in a thread of the farm's own, for robots on which evaluations differ, and for those to be
  ///        checked while there is only one simulator. An error in it is thrown by collect().
  SimulatorFarm(const SimulatorFarmSettings& settings, SimulatorConnector connector, Referee referee);
  ~SimulatorFarm() override;

  SimulatorFarm(const SimulatorFarm&) = delete;
  SimulatorFarm& operator=(const SimulatorFarm&) = delete;

  /// Takes note of a sign of life. From any thread.
  void heardFrom(const SimulatorAnnouncement& announcement);

  /// @throw InvalidInput if a program does not fit the settings.
  void submit(std::vector<EvaluationRequest> requests) override;
  std::vector<EvaluationResult> collect(std::chrono::milliseconds timeout) override;
  std::vector<WorkerStatus> status() const override;

  /// Takes no more work, aborts all calls and waits for the threads that make them, at most for two seconds.
  /// @return whether all have ended; those that have not hang in the network's code and never will do harm, but must
  ///         not see the end of main().
  bool close();

private:
  class State;

  const SimulatorConnector connector_;
  const std::shared_ptr<State> state_;
  std::thread watchdog_;
  std::thread referee_;
};
}  // namespace devo_evo
