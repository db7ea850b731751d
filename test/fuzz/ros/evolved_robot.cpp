// A champion that an evolver of the message's kind of body publishes, as a player receives it.

#include "fuzz/bodies.h"
#include "fuzz/input.h"
#include "fuzz/ros/received.h"
#include "ros/robot_source.h"

devo_evo::fuzz::Refusal devo_evo::fuzz::handle(const uint8_t* data, size_t size)
{
  try
  {
    const auto message = readMessage<EvolvedRobot>(received(data, size));
    const BodySettings settings =
        message.genome.body == "rigid" ? BodySettings(shortLivedQuadruped()) : BodySettings(twoVoxels());
    const ShownRobot robot = robotOf(message, settings);
    makeBody(settings)->validate(robot.program);
    require(robot.recorded && robot.descent && robot.descent->age >= 0);
    captionText(robot, *robot.recorded, 0.5);
  }
  catch (const InvalidInput& e)
  {
    return e.what();
  }
  return std::nullopt;
}
