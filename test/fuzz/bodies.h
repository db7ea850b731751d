#pragma once

#include "devo_evo/bodies/bodies.h"
#include "devo_evo/soft_body/simulation.h"

#include <atomic>

namespace devo_evo::fuzz
{
/// The smallest body that has a bond, and an arrangement to get wrong.
inline SoftBodySettings twoVoxels()
{
  SoftBodySettings settings;
  settings.grid_x = 1;
  settings.grid_y = 2;
  settings.grid_z = 1;
  settings.lifetime = 1.25;
  return settings;
}

/// A quadruped that lives as long.
inline RigidBodySettings shortLivedQuadruped()
{
  RigidBodySettings settings;
  settings.lifetime = twoVoxels().lifetime;
  return settings;
}

/// Whatever is taken for a robot can be simulated: a soft one for a step, a rigid one up to where it would be born.
inline void beginLife(const BodySettings& settings, const DevelopmentalProgram& program)
{
  if (settings.kind == BodyKind::SOFT)
  {
    makeSimulation(settings.soft, { program }, InstructionSet::SCALAR)->step();
    return;
  }
  const std::atomic<bool> stop = true;
  try
  {
    makeBody(settings)->evaluate({ program }, InstructionSet::SCALAR, &stop);
  }
  catch (const EvaluationAbandoned&)
  {
  }
}
}  // namespace devo_evo::fuzz
