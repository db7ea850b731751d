// Robots as JSON lines. The first byte chooses the body: its lowest bit the grid, the next the kind.

#include "devo_evo/bodies/bodies.h"
#include "devo_evo/experiment/json_lines.h"

#include "fuzz/bodies.h"
#include "fuzz/input.h"

#include <sstream>

namespace devo_evo::fuzz
{
namespace
{
BodySettings settingsFor(uint8_t choice)
{
  if ((choice & 2) != 0)
  {
    return BodySettings(RigidBodySettings());
  }
  return BodySettings((choice & 1) != 0 ? SoftBodySettings() : twoVoxels());
}
}  // namespace

Refusal handle(const uint8_t* data, size_t size)
{
  if (size == 0)
  {
    return "there is no first byte";
  }
  const BodySettings settings = settingsFor(data[0]);
  const std::shared_ptr<const Body> body = makeBody(settings);
  std::istringstream input(std::string(reinterpret_cast<const char*>(data + 1), size - 1));
  RobotReader reader(input, "input", *body);
  try
  {
    while (const auto robot = reader.next())
    {
      require(!toJson(robot->id).empty());
      beginLife(settings, robot->genome.program);
    }
  }
  catch (const InvalidInput& e)
  {
    return e.what();
  }
  return std::nullopt;
}
}  // namespace devo_evo::fuzz
