// A champion that an evolver publishes, as a player receives it.

#include "fuzz/input.h"
#include "fuzz/ros/received.h"
#include "ros/robot_source.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  using namespace devo_evo;
  SoftBodySettings settings;
  settings.grid_x = 2;
  settings.grid_y = settings.grid_z = 1;
  settings.lifetime = 1.25;
  try
  {
    const ShownRobot robot = robotOf(readMessage<EvolvedRobot>(fuzz::received(data, size)), BodySettings(settings));
    validate(robot.program, settings);
    fuzz::require(robot.recorded && robot.descent && robot.descent->age >= 0);
    captionText(robot, *robot.recorded, 0.5);
  }
  catch (const InvalidInput&)
  {
  }
  return 0;
}
