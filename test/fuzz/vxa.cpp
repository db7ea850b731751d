// Robots as VXA files.

#include "devo_evo/interchange/vxa.h"

#include "devo_evo/soft_body/simulation.h"
#include "fuzz/input.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  using namespace devo_evo;
  try
  {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const VxaRobot robot = readVxa(text, "input");
    // What is read can be simulated, and comes back the same.
    makeSimulation(robot.settings, { robot.genome.program }, InstructionSet::SCALAR)->step();
    if (robot.settings.actuation_frequency > 0.0)
    {
      fuzz::require(readVxa(toVxa(robot), "output").genome == robot.genome);
    }
  }
  catch (const InvalidInput&)
  {
  }
  return 0;
}
