#pragma once

#include "devo_evo/experiment/parameters.h"
#include "ros/departed_nodes.h"
#include "ros/simulator_farm.h"

#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <memory>

namespace devo_evo
{
/// Settings of a farm as the parameters say.
SimulatorFarmSettings farmSettings(const Parameters& parameters, const BodySettings& body, uint64_t fingerprint);

/// A SimulatorFarm of the simulators that announce themselves on topic `simulators`, asked through their services.
class RosFarm : public Farm
{
public:
  /// @param node in whose namespace the topic lies. Announcements arrive by its callback queue, which somebody must
  /// serve. @param signs_of_life where simulators that are heard of are noted.
  RosFarm(ros::NodeHandle node, const SimulatorFarmSettings& settings, std::shared_ptr<SignsOfLife> signs_of_life);

  ~RosFarm() override { signs_of_life_->stopListening(); }

  void submit(std::vector<EvaluationRequest> requests) override { farm_.submit(std::move(requests)); }
  std::vector<EvaluationResult> collect(std::chrono::milliseconds timeout) override { return farm_.collect(timeout); }
  std::vector<WorkerStatus> status() const override { return farm_.status(); }

  /// As SimulatorFarm::close().
  bool close();

private:
  void heardFrom(const SimulatorAnnouncement& announcement);

  const std::shared_ptr<SignsOfLife> signs_of_life_;
  SimulatorFarm farm_;
  ros::Subscriber announcements_;
};
}  // namespace devo_evo
