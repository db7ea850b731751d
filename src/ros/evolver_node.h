#pragma once

#include "devo_evo/archive/archive.h"
#include "devo_evo/experiment/experiment.h"
#include "devo_evo/experiment/parameters.h"
#include "ros/archive_services.h"
#include "ros/diagnostics.h"
#include "ros/idle_warning.h"
#include "ros/master_watch.h"
#include "ros/ros_farm.h"

#include <devo_evo/EvolvedRobot.h>

#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <std_srvs/Trigger.h>

#include <chrono>
#include <memory>
#include <optional>

namespace devo_evo
{
/// Runs an experiment on simulators that announce themselves.
///
/// Subscribes `simulators`; publishes `generation` (GenerationSummary), `champion` and `best` (EvolvedRobot, latched)
/// and /diagnostics; offers services `pause`, `resume`, `stop` (std_srvs/Trigger), `individual` and `lineage`. See
/// docs/nodes.md.
class EvolverNode : private ExperimentObserver
{
public:
  /// Opens the archive. @throw ArchiveError, InvalidInput
  explicit EvolverNode(const Parameters& parameters);

  /// Runs until the experiment is finished, stopped by service, or interrupted by a signal or by ROS.
  /// @throw ArchiveError if results cannot be kept.
  RunOutcome run();

  /// Ends all work with simulators and the master. @return false if threads hang in the network's code:
  /// SimulatorFarm::close(), MasterWatch::close().
  bool close();

private:
  using Clock = std::chrono::steady_clock;

  EvolverNode(const Parameters& parameters, const ExperimentSettings& settings);
  EvolverNode(const Parameters& parameters, const ExperimentSettings& settings, const Provenance& provenance);

  void generationCommitted(const GenerationReport& report) override;
  void tick() override;

  void awaitRecorder();
  void takeUp();
  void publishChampion(const EvolvedRobot& champion);
  void showProgress(const GenerationReport& report);
  void publishDiagnostics();
  void sayWhoWorked();

  bool pause(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool resume(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool stop(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  const ExperimentSettings settings_;
  ros::NodeHandle node_;
  std::unique_ptr<Archive> archive_;
  const std::shared_ptr<SignsOfLife> signs_of_life_ = std::make_shared<SignsOfLife>();
  RosFarm farm_;
  Experiment experiment_;
  ArchiveServices archive_services_;

  ExperimentStatus status_;
  std::optional<EvolvedRobot> best_;  // of all trials
  Clock::time_point started_;
  Clock::time_point next_progress_;
  Clock::time_point next_farm_report_;
  Clock::time_point diagnosed_;
  IdleWarning idle_warning_;

  ros::Publisher generation_;
  ros::Publisher champion_;
  ros::Publisher best_publisher_;
  ros::Publisher diagnostics_;
  ros::Publisher evaluation_settings_;
  ros::ServiceServer pause_;
  ros::ServiceServer resume_;
  ros::ServiceServer stop_;
  ros::AsyncSpinner callbacks_;
  std::unique_ptr<MasterWatch> master_watch_;
};
}  // namespace devo_evo
