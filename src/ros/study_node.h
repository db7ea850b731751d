#pragma once

#include "devo_evo/study/study.h"
#include "ros/diagnostics.h"
#include "ros/idle_warning.h"
#include "ros/master_watch.h"

#include <ros/node_handle.h>
#include <ros/spinner.h>

#include <chrono>
#include <functional>

namespace devo_evo
{
/// Runs a study (docs/study.md) on simulators that announce themselves on topic `simulators`, and publishes
/// `/diagnostics`.
class StudyNode : private StudyObserver
{
public:
  /// @throw InvalidInput
  explicit StudyNode(const Parameters& parameters);

  /// Runs until the study is finished, or interrupted by a signal or by ROS.
  /// @throw ArchiveError if results cannot be kept; InvalidInput.
  RunOutcome run();

  /// Ends all work with the network. @return false if threads hang in its code: SimulatorFarm::close(),
  /// MasterWatch::close().
  bool close();

private:
  using Clock = std::chrono::steady_clock;

  void partBegun(StudyPart part, size_t number, size_t parts) override;
  void say(const std::string& line) override;
  void showProgress(const std::string& line) override;
  bool stopRequested() override;

  std::unique_ptr<Farm> makeFarm(const BodySettings& body);

  Parameters parameters_;
  ros::NodeHandle node_;
  ros::AsyncSpinner callbacks_;
  IdleWarning idle_warning_;
  const std::shared_ptr<SignsOfLife> signs_of_life_ = std::make_shared<SignsOfLife>();
  MasterWatch master_watch_;
  ros::Publisher diagnostics_;
  StudyStatus status_;
  std::function<std::vector<WorkerStatus>()> workers_;  // of the present farm; empty between two
  bool clean_ = true;                                   // whether every farm could be closed
  Clock::time_point started_ = Clock::now();
  Clock::time_point next_progress_ = started_;
  Clock::time_point next_look_ = started_;
};
}  // namespace devo_evo
