// Robots as JSON lines. The first byte chooses the grid.

#include "devo_evo/experiment/json_lines.h"
#include "devo_evo/bodies/bodies.h"

#include "devo_evo/soft_body/simulation.h"
#include "fuzz/input.h"

#include <sstream>

namespace
{
using namespace devo_evo;

SoftBodySettings settingsFor(uint8_t choice)
{
  SoftBodySettings settings;
  if (choice % 2 == 0)
  {
    settings.grid_x = 1;
    settings.grid_y = 2;
    settings.grid_z = 1;
  }
  return settings;
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  if (size == 0)
  {
    return 0;
  }
  const SoftBodySettings settings = settingsFor(data[0]);
  const std::shared_ptr<const Body> body = makeSoftBody(settings);
  std::istringstream input(std::string(reinterpret_cast<const char*>(data + 1), size - 1));
  RobotReader reader(input, "input", *body);
  try
  {
    while (const auto robot = reader.next())
    {
      fuzz::require(!toJson(robot->id).empty());
      // Whatever is taken for a robot can be simulated.
      makeSimulation(settings, { robot->genome.program }, InstructionSet::SCALAR)->step();
    }
  }
  catch (const InvalidInput&)
  {
  }
  return 0;
}
