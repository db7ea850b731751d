#pragma once

#include "devo_evo/farm/farm.h"
#include "devo_evo/soft_body/simulation.h"
#include "ros/batch_display.h"
#include "ros/master_watch.h"

#include <devo_evo/EvaluateGenomes.h>

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <ros/steady_timer.h>

#include <atomic>
#include <map>
#include <memory>
#include <string>

namespace devo_evo
{
/// Simulates robots for whoever asks. Keeps nothing between requests: all that an evaluation depends on comes with it.
/// Once it is told that an evaluation was wrong, it refuses all requests, and goes on announcing that it is there.
///
/// Offers service ~evaluate (EvaluateGenomes); publishes `simulators` (SimulatorAnnouncement, latched) every
/// announcement period, `velocity` (VelocityTelemetry) for every robot evaluated, and `voxels` (BatchDisplay).
/// Evaluates in a thread of its own, one request at a time, so that it stays responsive; announcements go by the global
/// callback queue, which somebody must serve.
class SimulatorNode
{
public:
  /// Computes the engine fingerprint, which takes a moment, and announces itself.
  SimulatorNode(InstructionSet instruction_set, double announcement_period_s);

  /// Abandons the evaluation that runs.
  ~SimulatorNode();

  SimulatorNode(const SimulatorNode&) = delete;
  SimulatorNode& operator=(const SimulatorNode&) = delete;

private:
  bool evaluate(const ros::SerializedMessage& request, const std::string& caller, EvaluateGenomes::Response& response);
  void answer(const EvaluateGenomes::Request& request, const std::string& caller, EvaluateGenomes::Response& response);
  void beQuarantined(const std::string& reason, const std::string& by);
  void announce();

  const InstructionSet instruction_set_;
  const double announcement_period_s_;
  const std::map<std::string, uint64_t> fingerprints_;  ///< by kind of body
  std::atomic<bool> stop_{ false };
  std::atomic<bool> busy_{ false };
  std::atomic<int64_t> evaluations_{ 0 };
  std::string quarantine_;  // by whom, and why; empty: it is not. Of the evaluation thread alone

  ros::NodeHandle node_;
  ros::NodeHandle private_node_;
  ros::CallbackQueue requests_;
  ros::Publisher announcements_;
  ros::Publisher velocity_;
  BatchDisplay display_;
  ros::ServiceServer service_;
  ros::SteadyTimer announcement_timer_;
  ros::AsyncSpinner evaluation_thread_;
  std::unique_ptr<MasterWatch> master_watch_;
};
}  // namespace devo_evo
