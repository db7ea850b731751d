#pragma once

#include "devo_evo/archive/archive.h"
#include "devo_evo/evolution/trial.h"
#include "devo_evo/verification/verify.h"

#include <vector>

namespace devo_evo
{
/// Evolves a trial again, generation by generation, with the archive's evaluations instead of simulations, and compares
/// what comes about with what the archive says. Offences are thrown.
class TrialReplay
{
public:
  /// @throw Offence if the trial has more or fewer rows than its generations account for.
  TrialReplay(const Archive& archive, const ExperimentSettings& settings, int64_t trial);

  bool finished() const { return selected_ && trial_.generation() >= extent_.last_generation; }

  /// Lets the next generation be born and compares it. @return the newcomers as archived, with their genomes.
  std::vector<ArchivedIndividual> nextGeneration();

  /// Selects, and compares the survivors.
  void select();

  /// Everybody who took part in the selection that is to come, or is done.
  const std::vector<Individual>& candidates() const { return candidates_; }

  int64_t generation() const { return trial_.generation(); }
  int64_t storedGenomes() const { return stored_genomes_; }

private:
  ArchivedIndividual compareBirth(const Individual& born, const ArchivedIndividual* archived);
  void setEvaluation(const Individual& archived);
  void compareSelection(const GenerationRecord& record) const;

  const Archive& archive_;
  const ExperimentSettings settings_;
  const TrialExtent extent_;
  std::shared_ptr<const Body> body_;
  GenomeLayout layout_;
  Trial trial_;
  std::vector<Individual> candidates_;
  bool selected_ = false;
  bool begun_ = false;
  int64_t survivor_rows_ = 0;
  int64_t stored_genomes_ = 0;
};

/// Compares the outcome of a repeated life with the archive. @throw Offence naming the first measure that differs.
void compareLife(const Individual& archived, const Evaluation& repeated, const Body& body);
}  // namespace devo_evo
