#pragma once

#include "devo_evo/soft_body/developmental_program.h"
#include "devo_evo/soft_body/settings.h"

#include <string>
#include <vector>

namespace devo_evo
{
/// Robots whose whole lives are simulated.
struct LifeScene
{
  std::string name;
  SoftBodySettings settings;
  std::vector<DevelopmentalProgram> robots;
};

/// All of them; docs/benchmarks.md says what each is for.
std::vector<LifeScene> lifeScenes();

/// The scene of this name. @throw std::out_of_range if there is none.
LifeScene lifeScene(const std::string& name);
}  // namespace devo_evo
