#include "study/champions.h"

#include "devo_evo/archive/archive.h"

namespace devo_evo
{
bool RunChampion::develops() const
{
  return specOf(evolution.treatment).body_develops || specOf(evolution.treatment).control_develops;
}

std::vector<RunChampion> runChampions(const Parameters& parameters)
{
  std::vector<RunChampion> champions;
  for (const Arm& arm : analysedArms(parameters))
  {
    const auto archive = hasBegun(arm) ? openArchiveForReading(arm.settings.output) : nullptr;
    const auto states = archive ? archive->trialStates() : std::map<int64_t, TrialState>();
    if (states.empty() && arm.part == StudyPart::MAIN)
    {
      throw InvalidInput("there is no generation in " + archivePath(arm.settings.output) +
                         ": analyses are about its champions; run the part main first");
    }
    for (const auto& [trial, state] : states)
    {
      if (trial <= arm.settings.trials)
      {
        Individual champion = archive->readIndividual(trial, archive->championOf(trial)).individual;
        champions.push_back(
            { arm.name, arm.settings.evolution, std::move(champion), state.generation, arm.settings.output });
      }
    }
  }
  return champions;
}

std::vector<ArchivedIndividual> lineageOf(const RunChampion& champion)
{
  std::vector<ArchivedIndividual> lineage =
      openArchiveForReading(champion.output)->readLineage(champion.trial(), champion.id());
  for (const ArchivedIndividual& ancestor : lineage)
  {
    if (!ancestor.has_genome)
    {
      throw ArchiveError(archivePath(champion.output) + " has lost the genome of " +
                         individualName(champion.trial(), ancestor.individual.id) + ", an ancestor of a champion");
    }
  }
  return lineage;
}
}  // namespace devo_evo
