#pragma once

#include "devo_evo/bodies/bodies.h"
#include "devo_evo/evolution/settings.h"

#include <cstdint>
#include <string>
#include <vector>

namespace devo_evo
{
/// An experiment: one kind of body, one arm (treatment, profile, mutation rate), several trials side by side. Ranges
/// stand in experimentIntegers().
struct ExperimentSettings
{
  BodySettings body;
  EvolutionSettings evolution;
  int64_t trials = 1;        ///< independent repetitions, numbered from 1 [1]
  int64_t generations = 20;  ///< after generation 0, in every trial [1]
  std::string output;        ///< folder of the archive; absolute
  std::string founders;      ///< file that evolution.founders come from; absolute, or empty if all are random

  /// @throw InvalidInput naming the field, its value and what is allowed.
  void validate() const;

  /// Of the body alone, and that no parameter of another kind of body is given. @throw InvalidInput likewise.
  void validateBody() const;
};

/// The whole numbers of ExperimentSettings, in their order.
const std::vector<BoundedField<ExperimentSettings, int64_t>>& experimentIntegers();

/// Reads evolution.founders from the file `founders`, JSON lines (docs/tool.md, "Genomes"); nothing to do without one.
/// Where mutation rates evolve, robots without them get the minimum; elsewhere rates are left out.
/// @throw InvalidInput with file and line if a robot does not fit body, treatment or profile, or there are none or more
///        than the population has.
void loadFounders(ExperimentSettings& settings);

/// The folder an experiment writes to if none is named: $HOME/devo_evo/<treatment>-<profile>-<mutation
/// rate>-seed-<seed>, with rigid bodies rigid-<treatment>-seed-<seed>.
/// @throw InvalidInput if HOME is not an absolute path.
std::string defaultOutput(const ExperimentSettings& settings);
}  // namespace devo_evo
