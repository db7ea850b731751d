#pragma once

#include "devo_evo/experiment/parameters.h"
#include "ros/simulator_farm.h"

#include <ros/node_handle.h>
#include <ros/subscriber.h>

namespace devo_evo
{
/// Settings of a farm as the parameters say.
SimulatorFarmSettings farmSettings(const Parameters& parameters, const SoftBodySettings& body, uint64_t fingerprint);

/// A SimulatorFarm of the simulators that announce themselves on topic `simulators`, asked through their services.
class RosFarm : public Farm
{
public:
  /// @param node in whose namespace the topic lies. Announcements arrive by its callback queue, which somebody must
  /// serve.
  RosFarm(ros::NodeHandle node, const SimulatorFarmSettings& settings);

  void submit(std::vector<EvaluationRequest> requests) override { farm_.submit(std::move(requests)); }
  std::vector<EvaluationResult> collect(std::chrono::milliseconds timeout) override { return farm_.collect(timeout); }
  std::vector<WorkerStatus> status() const override { return farm_.status(); }

  /// As SimulatorFarm::close().
  bool close();

private:
  void heardFrom(const SimulatorAnnouncement& announcement);

  SimulatorFarm farm_;
  ros::Subscriber announcements_;
};
}  // namespace devo_evo
