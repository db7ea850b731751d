#pragma once

#include "devo_evo/evolution/settings.h"

#include <optional>

namespace devo_evo
{
/// The paper's settings but for the arm.
inline EvolutionSettings settingsOf(Treatment treatment, Profile profile,
                                    std::optional<double> mutation_rate = std::nullopt)
{
  EvolutionSettings settings;
  settings.treatment = treatment;
  settings.profile = profile;
  settings.mutation_rate = mutation_rate;
  return settings;
}
}  // namespace devo_evo
