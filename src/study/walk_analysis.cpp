#include "study/analysis_parts.h"

#include "study/walk.h"

namespace devo_evo
{
namespace
{
Work walkWork(const StudyContext& study, const RunChampion& champion, const WalkKind& kind, int64_t number)
{
  const std::vector<Genome> genomes = walk(kind, champion.individual.genome, champion.evolution, *study.body(),
                                           champion.trial(), number, study.parameters.study.walk_steps);
  Work work;
  std::vector<std::pair<Hash128, int64_t>> steps;
  for (const Genome& genome : genomes)
  {
    steps.push_back(
        { phenotypeHash(genome.program), work.robots.empty() ? 0 : voxelsChanged(work.robots.back(), genome.program) });
    work.robots.push_back(genome.program);
  }
  work.write = [study, champion, kind, number, steps]
  {
    int64_t step = 0;
    for (const auto& [phenotype, changed] : steps)
    {
      study.database.run(
          "INSERT OR REPLACE INTO walk_steps (arm, trial, id, space, robot, operator, walk, step, "
          "voxels_changed, phenotype_hash) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
          champion.arm, champion.trial(), champion.id(), toString(kind.space), kind.robot(), kind.mutationOperator(),
          number, step++, changed, phenotype);
    }
  };
  return work;
}
}  // namespace

Analysis walksAnalysis(const StudyContext& study, const std::vector<RunChampion>& champions)
{
  const StudySettings& settings = study.parameters.study;
  Analysis analysis = { study.world(), false, {} };
  for (const RunChampion& champion : champions)
  {
    for (const WalkKind& kind : walkKinds(champion.evolution.treatment, settings.walk_removed, settings.walk_one_voxel))
    {
      for (int64_t number = 1; number <= settings.walks; ++number)
      {
        const int64_t steps = study.count(
            "SELECT count(*) FROM walk_steps WHERE arm = ? AND trial = ? AND id = ? AND space = ? AND robot = ? "
            "AND operator = ? AND walk = ?",
            champion, toString(kind.space), kind.robot(), kind.mutationOperator(), number);
        if (steps < settings.walk_steps + 1)
        {
          analysis.work.push_back([=] { return walkWork(study, champion, kind, number); });
        }
      }
    }
  }
  return analysis;
}
}  // namespace devo_evo
