#pragma once

#include "devo_evo/bodies/bodies.h"
#include "devo_evo/evolution/settings.h"

#include <memory>
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

inline std::shared_ptr<const Body> bodyOf(int grid_x, int grid_y, int grid_z)
{
  SoftBodySettings settings;
  settings.grid_x = grid_x;
  settings.grid_y = grid_y;
  settings.grid_z = grid_z;
  return makeSoftBody(settings);
}

/// The paper's.
inline const Body& paperBody()
{
  static const std::shared_ptr<const Body> body = bodyOf(4, 4, 3);
  return *body;
}

inline GenomeLayout layoutOf(const EvolutionSettings& settings)
{
  return paperBody().layout(settings);
}
}  // namespace devo_evo
