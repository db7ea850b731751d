#include "study/analysis_parts.h"

#include "study/frozen.h"

namespace devo_evo
{
namespace
{
constexpr Moment MOMENTS[] = { Moment::BIRTH, Moment::MIDLIFE, Moment::DEATH };
constexpr Scope SCOPES[] = { Scope::BOTH, Scope::BODY, Scope::CONTROL };

Work freezeWork(const StudyContext& study, const RunChampion& champion)
{
  Work work;
  for (const Moment moment : MOMENTS)
  {
    for (const Scope scope : SCOPES)
    {
      work.robots.push_back(frozen(champion.program(), moment, scope));
    }
  }
  const GenomeLayout layout = study.body()->layout(champion.evolution);
  work.write = [study, champion, layout, robots = work.robots]
  {
    auto robot = robots.begin();
    for (const Moment moment : MOMENTS)
    {
      for (const Scope scope : SCOPES)
      {
        study.database.run(
            "INSERT OR REPLACE INTO variants (arm, trial, id, moment, scope, morphology_window, "
            "control_window, phenotype_hash) VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
            champion.arm, champion.trial(), champion.id(), toString(moment), toString(scope),
            morphologyWindow(*robot, layout), controlWindow(*robot, layout), phenotypeHash(*robot));
        ++robot;
      }
    }
  };
  return work;
}

Work traceWork(const StudyContext& study, const RunChampion& champion)
{
  Work work;
  work.robots = { champion.program(), frozen(champion.program(), Moment::BIRTH, Scope::BOTH) };
  work.write = [study, champion, robots = work.robots]
  {
    const char* const names[] = { "champion", "frozen_at_birth" };
    for (size_t robot = 0; robot < robots.size(); ++robot)
    {
      study.database.run("INSERT OR REPLACE INTO traces (arm, trial, id, robot, phenotype_hash) VALUES (?, ?, ?, ?, ?)",
                         champion.arm, champion.trial(), champion.id(), std::string(names[robot]),
                         phenotypeHash(robots[robot]));
    }
    study.database.checkReproduced(study.database.numberOf(study.world()), phenotypeHash(champion.program()),
                                   champion.individual.evaluation.value(), champion.name());
  };
  return work;
}
}  // namespace

Analysis removedAnalysis(const StudyContext& study, const std::vector<RunChampion>& champions)
{
  Analysis analysis = { study.world(), true, {} };
  for (const RunChampion& champion : champions)
  {
    const char* const done = "SELECT count(*) FROM variants WHERE arm = ? AND trial = ? AND id = ?";
    if (champion.develops() && study.count(done, champion) == 0)
    {
      analysis.work.push_back([study, champion] { return freezeWork(study, champion); });
    }
  }
  return analysis;
}

Analysis tracesAnalysis(const StudyContext& study, const std::vector<RunChampion>& champions)
{
  Analysis analysis = { study.world(), true, {} };
  for (const RunChampion& champion : champions)
  {
    if (study.count("SELECT count(*) FROM traces WHERE arm = ? AND trial = ? AND id = ?", champion) == 0)
    {
      analysis.work.push_back([=] { return traceWork(study, champion); });
    }
  }
  return analysis;
}

std::vector<Analysis> robustnessAnalyses(const StudyContext& study, const std::vector<RunChampion>& champions)
{
  std::vector<Analysis> analyses;
  for (const World& world : robustnessWorlds(study.parameters.experiment.body.soft, study.parameters.study))
  {
    Analysis analysis = { world, true, {} };
    const int64_t number = study.database.numberOf(world);
    for (const RunChampion& champion : champions)
    {
      const char* const done = "SELECT count(*) FROM robustness WHERE arm = ? AND trial = ? AND id = ? AND world = ?";
      if (study.count(done, champion, number) > 0)
      {
        continue;
      }
      const auto write = [=]
      {
        study.database.run(
            "INSERT OR REPLACE INTO robustness (arm, trial, id, world, phenotype_hash) VALUES (?, ?, ?, ?, ?)",
            champion.arm, champion.trial(), champion.id(), number, phenotypeHash(champion.program()));
      };
      analysis.work.push_back([=] { return Work{ { champion.program() }, write }; });
    }
    analyses.push_back(std::move(analysis));
  }
  return analyses;
}
}  // namespace devo_evo
