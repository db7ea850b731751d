#pragma once

#include "devo_evo/evolution/settings.h"
#include "devo_evo/soft_body/settings.h"

#include <string>

namespace devo_evo
{
/// An experiment: one arm (treatment, profile, mutation rate), several trials side by side.
struct ExperimentSettings
{
  SoftBodySettings body;
  EvolutionSettings evolution;
  int trials = 1;             ///< [1, 1 to 10000]
  int64_t generations = 20;   ///< after generation 0, in every trial [1, 0 to 1000000]
  std::string output;         ///< folder of the archive; absolute

  /// @throw InvalidInput
  void validate() const;
};
}  // namespace devo_evo
