#include "ros/checked_subscriber.h"
#include "ros/conversions.h"
#include "ros/robot_source.h"

#include <devo_evo/GetIndividual.h>

#include <ros/service.h>
#include <ros/service_client.h>

#include <map>
#include <mutex>

namespace devo_evo
{
namespace
{
class EvolverSource : public RobotSource
{
public:
  EvolverSource(ros::NodeHandle node, const RobotChoice& choice)
    : node_(std::move(node))
    , choice_(choice)
    , settings_subscriber_(subscribeChecked<EvaluationSettings>(
          node_, "settings", 1, [this](const EvaluationSettings& settings) { takeSettings(settings); }))
  {
    if (choice_.follows())
    {
      const std::string topic = choice_.trial ? "champion" : "best";
      robots_subscriber_ =
          subscribeChecked<EvolvedRobot>(node_, topic, 1000, [this](const EvolvedRobot& robot) { takeRobot(robot); });
    }
  }

  std::optional<ShownRobot> look() override
  {
    if (choice_.trial && !latest())
    {
      ask();
    }
    const auto robot = latest();
    const auto body = settings();
    try
    {
      return robot && body ? std::optional<ShownRobot>(robotOf(*robot, *body)) : std::nullopt;
    }
    catch (const InvalidInput& e)
    {
      if (!choice_.follows())
      {
        throw;
      }
      ROS_WARN_STREAM_THROTTLE(10.0, "cannot show " << individualName(robot->trial, robot->id) << ": " << e.what());
      return std::nullopt;
    }
  }

  std::string waitingFor() const override
  {
    return "no evolver has published " + node_.resolveName(settings() ? "champion" : "settings") + " yet";
  }

  void stop() override
  {
    std::lock_guard<std::mutex> lock(mutex_);
    stopped_ = true;
    client_.shutdown();
  }

private:
  void takeSettings(const EvaluationSettings& message)
  {
    const BodySettings settings = fromMsg(message);
    std::lock_guard<std::mutex> lock(mutex_);
    settings_ = settings;
  }

  void takeRobot(const EvolvedRobot& message)
  {
    if (choice_.trial && message.trial != *choice_.trial)
    {
      return;
    }
    std::lock_guard<std::mutex> lock(mutex_);
    latest_ = message;
  }

  std::optional<BodySettings> settings() const
  {
    std::lock_guard<std::mutex> lock(mutex_);
    return settings_;
  }

  std::optional<EvolvedRobot> latest() const
  {
    std::lock_guard<std::mutex> lock(mutex_);
    return latest_;
  }

  /// Asks the evolver for the individual, if there is one that can be asked.
  void ask()
  {
    if (!settings() || !ros::service::exists(node_.resolveName("individual"), false))
    {
      return;
    }
    ros::ServiceClient client;
    {
      std::lock_guard<std::mutex> lock(mutex_);
      if (stopped_)
      {
        return;
      }
      client_ = client = node_.serviceClient<GetIndividual>("individual", true);
    }
    GetIndividual::Request request;
    request.trial = *choice_.trial;
    request.id = choice_.id.value_or(GetIndividual::Request::CHAMPION);
    ros::SerializedMessage received;
    if (!client.call(ros::serialization::serializeMessage(request), received,
                     ros::service_traits::md5sum<GetIndividual>()))
    {
      return;
    }
    const auto answer = readMessage<GetIndividual::Response>(received);
    if (!answer.success && choice_.id)
    {
      throw InvalidInput(answer.message);
    }
    std::lock_guard<std::mutex> lock(mutex_);
    if (answer.success && !latest_)  // what is published is newer
    {
      latest_ = answer.individual;
    }
  }

  ros::NodeHandle node_;
  const RobotChoice choice_;
  mutable std::mutex mutex_;
  std::optional<BodySettings> settings_;
  std::optional<EvolvedRobot> latest_;
  ros::ServiceClient client_;
  bool stopped_ = false;
  ros::Subscriber settings_subscriber_;
  ros::Subscriber robots_subscriber_;
};
}  // namespace

ShownRobot robotOf(const EvolvedRobot& message, const BodySettings& settings)
{
  const bool sound = message.trial >= 1 && message.id >= 0 && message.born >= 0 && message.age >= 0 &&
                     message.born <= message.generation && message.age <= message.generation &&
                     message.age >= message.generation - message.born;
  if (!sound)
  {
    throw InvalidInput("trial, id, born, generation and age contradict each other");
  }
  ShownRobot robot;
  robot.name = individualName(message.trial, message.id);
  if (message.genome.arrays.empty() || message.genome.arrays.front().values.empty())
  {
    throw InvalidInput("the genome of individual " + robot.name + " was not kept and cannot be had again");
  }
  const std::shared_ptr<const Body> body = makeBody(settings);
  robot.body = settings;
  robot.program = fromMsg(message.genome, *body).program;
  robot.recorded = fromMsg(message.evaluation, *body);
  const int64_t age_at_birth = message.age - (message.generation - message.born);
  robot.descent = Descent{ message.trial,
                           message.id,
                           message.born,
                           age_at_birth,
                           toString(parseTreatment(message.treatment)),
                           message.morphology_window,
                           message.control_window };
  return robot;
}

std::unique_ptr<RobotSource> makeEvolverSource(ros::NodeHandle node, const RobotChoice& choice)
{
  return std::make_unique<EvolverSource>(std::move(node), choice);
}
}  // namespace devo_evo
