// Robots as VXA files.

#include "devo_evo/interchange/vxa.h"

#include "fuzz/bodies.h"
#include "fuzz/input.h"

devo_evo::fuzz::Refusal devo_evo::fuzz::handle(const uint8_t* data, size_t size)
{
  try
  {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const VxaRobot robot = readVxa(text, "input");
    beginLife(BodySettings(robot.settings), robot.genome.program);
    // What is read comes back the same.
    if (robot.settings.actuation_frequency > 0.0)
    {
      require(readVxa(toVxa(robot), "output").genome == robot.genome);
    }
  }
  catch (const InvalidInput& e)
  {
    return e.what();
  }
  return std::nullopt;
}
