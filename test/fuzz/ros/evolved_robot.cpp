// A champion that an evolver publishes, as a player receives it.

#include "fuzz/bodies.h"
#include "fuzz/input.h"
#include "fuzz/ros/received.h"
#include "ros/robot_source.h"

devo_evo::fuzz::Refusal devo_evo::fuzz::handle(const uint8_t* data, size_t size)
{
  const BodySettings settings(twoVoxels());
  try
  {
    const ShownRobot robot = robotOf(readMessage<EvolvedRobot>(received(data, size)), settings);
    validate(robot.program, settings.soft);
    require(robot.recorded && robot.descent && robot.descent->age >= 0);
    captionText(robot, *robot.recorded, 0.5);
  }
  catch (const InvalidInput& e)
  {
    return e.what();
  }
  return std::nullopt;
}
