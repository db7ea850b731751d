#include "study/worlds.h"

#include "devo_evo/soft_body/text.h"

namespace devo_evo
{
World asEvolved(const SoftBodySettings& body)
{
  return { "as_evolved", "none", std::nullopt, body };
}

std::vector<World> robustnessWorlds(const SoftBodySettings& body, const StudySettings& study)
{
  std::vector<World> worlds = { asEvolved(body) };
  const auto add = [&](const std::string& quantity, const std::string& sign, double value) -> SoftBodySettings&
  {
    worlds.push_back({ quantity + sign + toText(value), quantity, value, body });
    return worlds.back().body;
  };
  for (const double factor : study.friction_factors)
  {
    SoftBodySettings& changed = add("friction", "*", factor);
    changed.static_friction *= factor;
    changed.dynamic_friction *= factor;
  }
  for (const double factor : study.gravity_factors)
  {
    add("gravity", "*", factor).gravity *= factor;
  }
  for (const double slope : study.slopes)
  {
    add("slope", "=", slope).slope = slope;
  }
  for (const double factor : study.amplitude_factors)
  {
    add("actuation_amplitude", "*", factor).actuation_amplitude *= factor;
  }
  for (const World& world : worlds)
  {
    try
    {
      world.body.validate();
    }
    catch (const InvalidInput& error)
    {
      throw InvalidInput("robustness, " + world.name + ": " + error.what());
    }
  }
  return worlds;
}
}  // namespace devo_evo
