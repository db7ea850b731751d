#include "ros/ros_farm.h"

#include "devo_evo/soft_body/simulation.h"
#include "ros/conversions.h"
#include "ros/message_reader.h"

#include <ros/console.h>
#include <ros/service_client.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <utility>

namespace devo_evo
{
namespace
{
/// A connection by one persistent service client. roscpp never times a call out, but a client that is shut down by
/// another thread returns from it.
class ServiceConnection : public SimulatorConnection
{
public:
  explicit ServiceConnection(const std::string& service) : service_(service) {}

  bool call(const EvaluateGenomes::Request& request, EvaluateGenomes::Response& response) override
  {
    ros::ServiceClient client = connectedClient();
    ros::SerializedMessage received;
    if (!client.isValid() || !client.call(ros::serialization::serializeMessage(request), received,
                                          ros::service_traits::md5sum<EvaluateGenomes>()))
    {
      return false;
    }
    response = readMessage<EvaluateGenomes::Response>(received);
    return true;
  }

  void abort() override
  {
    ros::ServiceClient client;
    {
      std::lock_guard<std::mutex> lock(mutex_);
      aborted_ = true;
      client = client_;
    }
    client.shutdown();
  }

private:
  /// The client, made on first use, in the thread that calls: it is looked up at the master, which may take minutes
  /// when the network loses packets and cannot be interrupted. Invalid if the connection was aborted meanwhile.
  ros::ServiceClient connectedClient()
  {
    {
      std::lock_guard<std::mutex> lock(mutex_);
      if (aborted_ || client_.isValid())
      {
        return aborted_ ? ros::ServiceClient() : client_;
      }
    }
    ros::ServiceClient client(service_, true, ros::M_string(), ros::service_traits::md5sum<EvaluateGenomes>());
    std::lock_guard<std::mutex> lock(mutex_);
    client_ = client;
    return aborted_ ? ros::ServiceClient() : client;
  }

  const std::string service_;
  std::mutex mutex_;
  ros::ServiceClient client_;
  bool aborted_ = false;
};
}  // namespace

SimulatorFarmSettings farmSettings(const Parameters& parameters, const BodySettings& body, uint64_t fingerprint)
{
  SimulatorFarmSettings settings;
  settings.body = body;
  settings.engine_fingerprint = fingerprint;
  settings.batch_timeout = std::chrono::duration<double>(parameters.batch_timeout);
  settings.checked_fraction = parameters.checked_fraction;
  return settings;
}

RosFarm::RosFarm(ros::NodeHandle node, const SimulatorFarmSettings& settings,
                 std::shared_ptr<SignsOfLife> signs_of_life)
  : signs_of_life_(std::move(signs_of_life))
  , farm_(
        settings,
        [](const SimulatorAnnouncement& simulator) { return std::make_shared<ServiceConnection>(simulator.service); },
        [body = makeBody(settings.body)](const DevelopmentalProgram& robot, const std::atomic<bool>& stop)
        { return body->evaluate({ robot }, bestInstructionSet(), &stop).front(); })
  , announcements_(node.subscribe("simulators", 1000, &RosFarm::heardFrom, this))
{
}

bool RosFarm::close()
{
  signs_of_life_->stopListening();
  announcements_.shutdown();
  return farm_.close();
}

void RosFarm::heardFrom(const SimulatorAnnouncement& announcement)
{
  try
  {
    validate(announcement);
  }
  catch (const InvalidInput& e)
  {
    ROS_WARN_STREAM_THROTTLE(10.0, "ignored an announcement of a simulator: " << e.what());
    return;
  }
  constexpr std::chrono::duration<double> shortest_memory(10.0);
  const std::chrono::duration<double> memory(10.0 * announcement.period);
  signs_of_life_->note(announcement.name,
                       std::chrono::duration_cast<SignsOfLife::Clock::duration>(std::max(memory, shortest_memory)));
  farm_.heardFrom(announcement);
}
}  // namespace devo_evo
