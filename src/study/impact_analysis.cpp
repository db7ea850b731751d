#include "study/analysis_parts.h"

#include "study/mutation_count.h"

namespace devo_evo
{
namespace
{
Work impactWork(const StudyContext& study, const EvolutionSettings& settings)
{
  const int64_t reproductions = study.parameters.study.impact_reproductions;
  const MutationCount count = countMutations(settings, *study.body(), reproductions);
  Work work;
  work.write = [=]
  {
    study.database.run(
        "INSERT OR REPLACE INTO mutational_impact (treatment, profile, traits, mutation_rate, "
        "reproductions, voxels_changed_mean, voxels_changed_sd, genes_changed_mean, genes_changed_sd) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)",
        toString(settings.treatment), toString(settings.profile),
        static_cast<int64_t>(evolvingTraits(study.body()->layout(settings)).size()), *settings.mutation_rate,
        reproductions, count.voxels.mean, count.voxels.standard_deviation, count.genes.mean,
        count.genes.standard_deviation);
  };
  return work;
}
}  // namespace

Analysis impactAnalysis(const StudyContext& study)
{
  Analysis analysis = { study.world(), false, {} };
  for (const TreatmentSpec& spec : TREATMENTS)
  {
    for (const double rate : study.parameters.study.sweep_48ths)
    {
      EvolutionSettings settings = study.parameters.experiment.evolution;
      settings.treatment = spec.treatment;
      settings.mutation_rate = rate / 48.0;
      const int64_t counted = study.database.number(
          "SELECT coalesce(max(reproductions), 0) FROM mutational_impact WHERE treatment = ? AND profile = ? AND "
          "mutation_rate = ?",
          std::string(spec.name), toString(settings.profile), *settings.mutation_rate);
      if (counted < study.parameters.study.impact_reproductions)
      {
        analysis.work.push_back([=] { return impactWork(study, settings); });
      }
    }
  }
  return analysis;
}
}  // namespace devo_evo
