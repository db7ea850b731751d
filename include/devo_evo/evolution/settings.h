#pragma once

#include "devo_evo/soft_body/settings.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace devo_evo
{
/// The paper's two treatments.
enum class Treatment
{
  EVO,      ///< fixed for life: final values equal initial ones
  EVO_DEVO  ///< resting lengths and phases develop from initial to final values
};

/// Where the paper's text and its released code differ, which of them is followed (README, "Departures").
enum class Profile
{
  PAPER,  ///< phases within +-1/4 cycle; if no trait is selected for mutation, one is picked; rates start at 1/48
  RELEASED_CODE  ///< phases within +-1 cycle; redrawn until a trait is selected; rates start after one meta-mutation
};

std::string toString(Treatment treatment);          ///< "evo" or "evo_devo"
std::string toString(Profile profile);              ///< "paper" or "released_code"
Treatment parseTreatment(const std::string& name);  ///< @throw InvalidInput
Profile parseProfile(const std::string& name);      ///< @throw InvalidInput

/// Everything that the evolutionary algorithm depends on besides body and physics. Defaults are the paper's; ranges
/// stand in evolutionIntegers() and evolutionReals(), except those of mutation_rate and seed.
struct EvolutionSettings
{
  Treatment treatment = Treatment::EVO_DEVO;
  Profile profile = Profile::PAPER;
  std::optional<double> mutation_rate;  ///< lambda, fixed and equal for all voxels [1, 0 to 1]; none: self-adaptive

  int population = 30;        ///< survivors of each generation [1]
  int random_injections = 1;  ///< random individuals of age 0 that join each generation [1]
  int64_t seed = 1;           ///< of all randomness [1, 0 to 2^63 - 1]

  double size_mutation_sigma = 1.0;         ///< of a size gene [1]; 0.75 cm of resting length
  double meta_mutation_sigma = 4.0 / 48;    ///< of a mutation rate, at every reproduction [1]
  double minimum_mutation_rate = 1.0 / 48;  ///< lower bound and start of self-adaptive mutation rates [1]

  /// Bound of a phase, and standard deviation of its mutation [cycles]: 1/4 (paper) or 1 (released code).
  double phaseLimit() const;

  /// Names what decides the random numbers besides the seed: "evo_devo/paper/self_adaptive", "evo/released_code/0.5".
  std::string arm() const;

  /// @throw InvalidInput naming the field, its value and its range.
  void validate() const;
};

/// The whole numbers and the real numbers of EvolutionSettings, in their order.
const std::vector<BoundedField<EvolutionSettings, int>>& evolutionIntegers();
const std::vector<BoundedField<EvolutionSettings, double>>& evolutionReals();
}  // namespace devo_evo
