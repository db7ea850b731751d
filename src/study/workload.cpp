#include "study/workload.h"

#include "study/champions.h"
#include "study/study_tables.h"
#include "study/walk.h"
#include "study/worlds.h"

#include <algorithm>

namespace devo_evo
{
namespace
{
int64_t evaluationsOf(const EvolutionSettings& settings, int64_t generations)
{
  return settings.population + generations * (settings.population + settings.random_injections);
}

Workload ofEvolution(StudyPart part, const Parameters& parameters)
{
  Workload load = { part };
  for (const Arm& arm : armsOf(part, parameters))
  {
    const ExperimentSettings& settings = arm.settings;
    load.evaluations += settings.trials * evaluationsOf(settings.evolution, settings.generations);
    if (hasBegun(arm))
    {
      for (const auto& [trial, state] : openArchiveForReading(settings.output)->trialStates())
      {
        const bool wanted = trial <= settings.trials;
        load.left -= wanted ? evaluationsOf(settings.evolution, std::min(state.generation, settings.generations)) : 0;
      }
    }
  }
  load.left += load.evaluations;
  return load;
}

/// Somebody whom analyses are about, or will be.
struct Subject
{
  Treatment treatment;
  int64_t ancestors;  ///< with itself; of somebody still to evolve, a guess
};

std::vector<Subject> subjects(const Parameters& parameters, bool evolved)
{
  std::vector<Subject> subjects;
  if (evolved)
  {
    for (const RunChampion& champion : runChampions(parameters))
    {
      subjects.push_back({ champion.evolution.treatment, static_cast<int64_t>(lineageOf(champion).size()) });
    }
    return subjects;
  }
  constexpr int64_t generations_per_ancestor = 3, longest = 150;  // of lineages seen so far, and in the paper's Fig. 6
  for (const Arm& arm : analysedArms(parameters))
  {
    const int64_t guess = 1 + std::min(longest, arm.settings.generations / generations_per_ancestor);
    subjects.insert(subjects.end(), static_cast<size_t>(arm.settings.trials),
                    { arm.settings.evolution.treatment, guess });
  }
  return subjects;
}

int64_t evaluationsFor(StudyPart part, const Subject& subject, const Parameters& parameters)
{
  const StudySettings& study = parameters.study;
  const TreatmentSpec& treatment = specOf(subject.treatment);
  const bool develops = treatment.body_develops || treatment.control_develops;
  switch (part)
  {
    case StudyPart::REMOVED:
      return develops ? 9 : 0;
    case StudyPart::WALKS:
      return static_cast<int64_t>(walkKinds(subject.treatment, study.walk_removed, study.walk_one_voxel).size()) *
             study.walks * (study.walk_steps + 1);
    case StudyPart::LINEAGES:
      return subject.ancestors;
    case StudyPart::TRACES:
      return 2;
    case StudyPart::ROBUSTNESS:
      return static_cast<int64_t>(robustnessWorlds(parameters.experiment.body.soft, study).size());
    default:
      return 0;
  }
}

/// Rows about present champions, one for each robot that a part has simulated.
int64_t rowsDone(StudyPart part, const std::string& path)
{
  const char* sql = "SELECT 0";
  switch (part)
  {
    case StudyPart::REMOVED:
      sql = "SELECT count(*) FROM variants JOIN champions USING (arm, trial, id)";
      break;
    case StudyPart::WALKS:
      sql = "SELECT count(*) FROM walk_steps JOIN champions USING (arm, trial, id)";
      break;
    case StudyPart::LINEAGES:
      sql =
          "SELECT count(*) FROM ancestors AS a JOIN champions AS c ON c.arm = a.arm AND c.trial = a.trial AND "
          "c.id = a.champion";
      break;
    case StudyPart::TRACES:
      sql = "SELECT count(*) FROM traces JOIN champions USING (arm, trial, id)";
      break;
    case StudyPart::ROBUSTNESS:
      sql = "SELECT count(*) FROM robustness JOIN champions USING (arm, trial, id)";
      break;
    default:
      break;
  }
  const auto count = [&]
  {
    Connection connection = connectForReading(path);
    checkSchema(connection, path, studyFile());
    Query query = connection.query(sql);
    query.next();
    return query.natural();
  };
  return guarded(path, count);
}
}  // namespace

std::vector<Workload> workloads(const Parameters& parameters)
{
  const bool evolved = ofEvolution(StudyPart::MAIN, parameters).left == 0;
  const std::string database = studyDatabasePath(parameters.experiment.output);
  const bool begun = evolved && hasBegun(database);
  const std::vector<Subject> about = subjects(parameters, evolved);
  std::vector<Workload> loads;
  for (const StudyPart part : partsOf(parameters.study))
  {
    if (!armsOf(part, parameters).empty())
    {
      loads.push_back(ofEvolution(part, parameters));
      continue;
    }
    Workload load = { part };
    for (const Subject& subject : about)
    {
      load.evaluations += evaluationsFor(part, subject, parameters);
    }
    load.left = std::max<int64_t>(0, load.evaluations - (begun ? rowsDone(part, database) : 0));
    loads.push_back(load);
  }
  return loads;
}
}  // namespace devo_evo
