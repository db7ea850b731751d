#pragma once

#include "devo_evo/soft_body/settings.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace devo_evo
{
struct Genome;

/// What of a robot develops: changes over its life from initial to final values. The first two are the paper's.
/// To add a treatment, give it a name here and a row in TREATMENTS; everything else follows (docs/evolution.md).
enum class Treatment
{
  EVO,
  EVO_DEVO,
  EVO_DEVO_BODY,
  EVO_DEVO_CONTROL
};

/// What a treatment means.
struct TreatmentSpec
{
  Treatment treatment;
  const char* name;       ///< as in YAML, launch files and on the command line
  bool body_develops;     ///< resting lengths; else final values equal initial ones
  bool control_develops;  ///< phases; else final values equal initial ones
};

constexpr TreatmentSpec TREATMENTS[] = {
  { Treatment::EVO, "evo", false, false },
  { Treatment::EVO_DEVO, "evo_devo", true, true },
  { Treatment::EVO_DEVO_BODY, "evo_devo_body", true, false },
  { Treatment::EVO_DEVO_CONTROL, "evo_devo_control", false, true },
};

/// The treatment's row of TREATMENTS.
const TreatmentSpec& specOf(Treatment treatment);

/// Who survives a generation. The first is the paper's; the others are baselines (docs/evolution.md, "Baselines").
enum class Selection
{
  AFPO,          ///< Age-Fitness-Pareto optimisation
  NEUTRAL,       ///< drift: everybody is equally likely to survive
  RANDOM_SEARCH  ///< nobody has children: all newcomers are random, and the fittest survive
};

/// Where the paper's text and its released code differ, which of them is followed (README, "Departures").
enum class Profile
{
  PAPER,  ///< phases within +-1/4 cycle; if no trait is selected for mutation, one is picked; rates start at 1/48
  RELEASED_CODE  ///< phases within +-1 cycle; redrawn until a trait is selected; rates start after one meta-mutation
};

std::string toString(Treatment treatment);          ///< its name in TREATMENTS
std::string toString(Profile profile);              ///< "paper" or "released_code"
std::string toString(Selection selection);          ///< "afpo", "neutral" or "random_search"
Treatment parseTreatment(const std::string& name);  ///< @throw InvalidInput
Profile parseProfile(const std::string& name);      ///< @throw InvalidInput
Selection parseSelection(const std::string& name);  ///< @throw InvalidInput

/// For messages and documentation: "evo, evo_devo, evo_devo_body or evo_devo_control".
std::string treatmentNames();

/// Everything that the evolutionary algorithm depends on besides body and physics. Defaults are the paper's; ranges
/// stand in evolutionIntegers() and evolutionReals(), except those of mutation_rate and seed.
struct EvolutionSettings
{
  Treatment treatment = Treatment::EVO_DEVO;
  Profile profile = Profile::PAPER;
  Selection selection = Selection::AFPO;
  std::optional<double> mutation_rate;  ///< lambda, fixed and equal for all voxels [1, 0 to 1]; none: self-adaptive

  int population = 30;        ///< survivors of each generation [1]
  int random_injections = 1;  ///< random individuals of age 0 that join each generation [1]
  int64_t seed = 1;           ///< of all randomness [1, 0 to 2^63 - 1]

  /// The first founders of every trial, in the order of their ids; further ones are random, as all are if there are
  /// none.
  std::shared_ptr<const std::vector<Genome>> founders;

  double size_mutation_sigma = 1.0;         ///< of a size gene [1]; 0.75 cm of resting length
  double meta_mutation_sigma = 4.0 / 48;    ///< of a mutation rate, at every reproduction [1]
  double minimum_mutation_rate = 1.0 / 48;  ///< lower bound and start of self-adaptive mutation rates [1]

  double rigid_mutation_sigma = 0.5;  ///< of a quadruped's weights and leg lengths [share of their range]

  /// Bound of a phase, and standard deviation of its mutation [cycles]: 1/4 (paper) or 1 (released code).
  double phaseLimit() const;

  /// Names what decides the random numbers of soft bodies besides the seed: "evo_devo/paper/self_adaptive",
  /// "evo/released_code/0.5", "evo/paper/self_adaptive/neutral".
  std::string arm() const;

  /// @throw InvalidInput naming the field, its value and its range.
  void validate() const;
};

/// The whole numbers and the real numbers of EvolutionSettings, in their order.
const std::vector<BoundedField<EvolutionSettings, int>>& evolutionIntegers();
const std::vector<BoundedField<EvolutionSettings, double>>& evolutionReals();
}  // namespace devo_evo
