#pragma once

#include "study/arms.h"
#include "study/study_database.h"

#include <memory>
#include <string>
#include <vector>

namespace devo_evo
{
/// The champion of a trial's last committed generation, whom analyses are about.
struct RunChampion
{
  std::string arm;
  EvolutionSettings evolution;
  Individual individual;   ///< with genome and evaluation
  int64_t generation = 0;  ///< the trial's last
  std::string output;      ///< folder of the arm

  int64_t trial() const { return individual.trial; }
  int64_t id() const { return individual.id; }
  std::string name() const { return arm + " " + individualName(trial(), id()); }
  const DevelopmentalProgram& program() const { return individual.genome.program; }
  bool develops() const;
};

/// The run champions of the analysed arms, up to `trials` of each.
/// @throw InvalidInput if there are none.
std::vector<RunChampion> runChampions(const Parameters& parameters);

/// The champion and its ancestors, oldest first. @throw ArchiveError
std::vector<ArchivedIndividual> lineageOf(const RunChampion& champion);
}  // namespace devo_evo
