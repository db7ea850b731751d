#pragma once

#include "devo_evo/evolution/body.h"
#include "devo_evo/evolution/settings.h"

#include <cstdint>

namespace devo_evo
{
/// Mean of whole numbers, and standard deviation of single ones.
struct Spread
{
  double mean = 0.0;
  double standard_deviation = 0.0;
};

/// What reproductions changed.
struct MutationCount
{
  Spread voxels;  ///< in at least one trait
  Spread genes;   ///< of all traits
};

/// Reproductions of one random parent, counted. A pure function of its arguments. @pre reproductions > 1
MutationCount countMutations(const EvolutionSettings& settings, const Body& body, int64_t reproductions);
}  // namespace devo_evo
