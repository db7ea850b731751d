#include "study/analysis_parts.h"

#include "archive/bytes.h"
#include "study/heterochrony.h"

namespace devo_evo
{
namespace
{
void writeAncestor(const StudyContext& study, const RunChampion& champion,
                   const std::vector<ArchivedIndividual>& lineage, size_t position)
{
  const ArchivedIndividual& ancestor = lineage[position];
  const DevelopmentalProgram& program = ancestor.individual.genome.program;
  const double limit = champion.evolution.phaseLimit();
  const GenomeLayout layout = study.body()->layout(champion.evolution);
  std::optional<WindowClosing> body, control;
  if (position > 0)
  {
    const DevelopmentalProgram& parent = lineage[position - 1].individual.genome.program;
    body = morphologyClosing(parent, program);
    control = controlClosing(parent, program, limit);
  }
  const auto share = [](const std::optional<WindowClosing>& closing, double WindowClosing::*end)
  { return closing ? std::optional<double>((*closing).*end + 0.0) : std::nullopt; };
  study.database.checkReproduced(study.database.numberOf(study.world()), phenotypeHash(program),
                                 ancestor.individual.evaluation.value(),
                                 champion.arm + " " + individualName(champion.trial(), ancestor.individual.id));
  study.database.run(
      "INSERT OR REPLACE INTO ancestors (arm, trial, champion, position, id, generation, morphology_window, "
      "control_window, body_initial_towards_final, body_final_towards_initial, control_initial_towards_final, "
      "control_final_towards_initial, phenotype_hash) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
      champion.arm, champion.trial(), champion.id(), static_cast<int64_t>(position), ancestor.individual.id,
      ancestor.individual.generation, morphologyWindow(program, layout), controlWindow(program, layout),
      share(body, &WindowClosing::initial_towards_final), share(body, &WindowClosing::final_towards_initial),
      share(control, &WindowClosing::initial_towards_final), share(control, &WindowClosing::final_towards_initial),
      phenotypeHash(program));
}

Work lineageWork(const StudyContext& study, const RunChampion& champion)
{
  Work work;
  const std::vector<ArchivedIndividual> lineage = lineageOf(champion);
  for (const ArchivedIndividual& ancestor : lineage)
  {
    work.robots.push_back(ancestor.individual.genome.program);
  }
  work.write = [study, champion, lineage]
  {
    for (size_t position = 0; position < lineage.size(); ++position)
    {
      writeAncestor(study, champion, lineage, position);
    }
  };
  return work;
}

/// Nothing is simulated for it: windows depend on genomes alone.
Work neutralWork(const StudyContext& study, const RunChampion& champion)
{
  const std::vector<ArchivedIndividual> lineage = lineageOf(champion);
  std::vector<Windows> replicates;
  for (int64_t replicate = 1; replicate <= study.parameters.study.neutral_lineages; ++replicate)
  {
    replicates.push_back(neutralWindows(lineage, champion.evolution, *study.body(), champion.trial(), replicate));
  }
  Work work;
  work.write = [study, champion, replicates]
  {
    int64_t replicate = 0;
    for (const Windows& windows : replicates)
    {
      study.database.run(
          "INSERT OR REPLACE INTO neutral_lineages (arm, trial, champion, replicate, "
          "morphology_windows, control_windows) VALUES (?, ?, ?, ?, ?, ?)",
          champion.arm, champion.trial(), champion.id(), ++replicate, numbersToBytes(windows.morphology),
          numbersToBytes(windows.control));
    }
  };
  return work;
}
}  // namespace

Analysis lineagesAnalysis(const StudyContext& study, const std::vector<RunChampion>& champions)
{
  Analysis analysis = { study.world(), true, {} };
  for (const RunChampion& champion : champions)
  {
    const char* const ancestors = "SELECT count(*) FROM ancestors WHERE arm = ? AND trial = ? AND champion = ?";
    if (study.count(ancestors, champion) == 0)
    {
      analysis.work.push_back([=] { return lineageWork(study, champion); });
    }
    const char* const neutral = "SELECT count(*) FROM neutral_lineages WHERE arm = ? AND trial = ? AND champion = ?";
    if (champion.develops() && study.count(neutral, champion) < study.parameters.study.neutral_lineages)
    {
      analysis.work.push_back([=] { return neutralWork(study, champion); });
    }
  }
  return analysis;
}
}  // namespace devo_evo
