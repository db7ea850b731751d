#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace devo_evo
{
/// How large a study is: what all its numbers are unless they are given (docs/study.md, "Scales").
enum class Scale
{
  QUICK,      ///< minutes
  OVERNIGHT,  ///< a night
  PAPER       ///< the paper's own
};

std::string toString(Scale scale);          ///< "quick", "overnight" or "paper"
Scale parseScale(const std::string& name);  ///< @throw InvalidInput

/// A part of a study that can be run alone (docs/study.md, "Parts").
enum class StudyPart
{
  MAIN,
  PARTIAL,
  REMOVED,
  WALKS,
  LINEAGES,
  TRACES,
  ROBUSTNESS,
  IMPACT,
  BASELINES,
  SWEEP,
  RIGID
};

/// All parts, in the order in which they run.
const std::vector<StudyPart>& studyParts();

std::string toString(StudyPart part);  ///< "main", "removed", ...

/// Parts from their names, separated by commas; in the order in which they run, each once. None if the text is empty.
/// @throw InvalidInput
std::vector<StudyPart> parseStudyParts(const std::string& names);
std::string toString(const std::vector<StudyPart>& parts);

/// What a study does besides the parameters of its experiments. The numbers are the paper's where it has them.
struct StudySettings
{
  Scale scale = Scale::QUICK;
  std::vector<StudyPart> only;  ///< the parts to run; none: all but PARTIAL

  int64_t baseline_trials = 30;
  int64_t baseline_generations = 10000;
  int64_t sweep_trials = 30;
  int64_t sweep_generations = 10000;
  std::vector<double> sweep_48ths = { 1, 2, 4, 8, 16, 24, 32, 48 };  ///< fixed mutation rates [1/48]

  int64_t rigid_trials = 30;  ///< of each treatment with rigid bodies
  int64_t rigid_generations = 200;

  int64_t walks = 10;                     ///< random walks of each kind from each run champion
  int64_t walk_steps = 1000;              ///< of each walk
  bool walk_removed = true;               ///< whether champions frozen at birth are walked, too
  bool walk_one_voxel = true;             ///< whether there are walks of one voxel a step, too
  int64_t neutral_lineages = 100;         ///< made for each run champion's lineage
  int64_t impact_reproductions = 100000;  ///< counted for each mutation rate

  std::vector<double> friction_factors = { 0.5, 0.75, 1.5, 2 };  ///< of both coefficients
  std::vector<double> gravity_factors = { 0.5, 0.75, 1.5, 2 };
  std::vector<double> amplitude_factors = { 0.5, 0.75, 1.25, 1.5 };  ///< of actuation
  std::vector<double> slopes = { -0.1, -0.05, 0.05, 0.1 };           ///< rise over run along +y
};

/// The parts that a study with these settings runs.
std::vector<StudyPart> partsOf(const StudySettings& settings);
}  // namespace devo_evo
