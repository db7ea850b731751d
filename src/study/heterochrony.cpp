#include "study/heterochrony.h"

#include "devo_evo/evolution/genome.h"

#include <cmath>

namespace devo_evo
{
namespace
{
using Genes = std::vector<double>;

/// @param limit genes lie within +-limit.
WindowClosing closing(const Genes& initial, const Genes& final, const Genes& new_initial, const Genes& new_final,
                      double limit)
{
  WindowClosing sum;
  for (size_t voxel = 0; voxel < initial.size(); ++voxel)
  {
    // Shares of moving one end, with the other as it was and as it becomes: neither goes first.
    const double before = std::abs(final[voxel] - initial[voxel]);
    const double initial_moved = std::abs(final[voxel] - new_initial[voxel]);
    const double final_moved = std::abs(new_final[voxel] - initial[voxel]);
    const double after = std::abs(new_final[voxel] - new_initial[voxel]);
    sum.initial_towards_final += 0.5 * ((before - initial_moved) + (final_moved - after));
    sum.final_towards_initial += 0.5 * ((before - final_moved) + (initial_moved - after));
  }
  const double widest = 2.0 * limit * static_cast<double>(initial.size());
  return { sum.initial_towards_final / widest, sum.final_towards_initial / widest };
}
}  // namespace

WindowClosing morphologyClosing(const DevelopmentalProgram& parent, const DevelopmentalProgram& child)
{
  return closing(parent.morphology_initial, parent.morphology_final, child.morphology_initial, child.morphology_final,
                 1.0);
}

WindowClosing controlClosing(const DevelopmentalProgram& parent, const DevelopmentalProgram& child, double phase_limit)
{
  return closing(parent.control_initial, parent.control_final, child.control_initial, child.control_final, phase_limit);
}

Windows neutralWindows(const std::vector<ArchivedIndividual>& lineage, const EvolutionSettings& settings,
                       const Body& body, int64_t trial, int64_t replicate)
{
  const GenomeLayout layout = body.layout(settings);
  EvolutionSettings drift = settings;
  drift.meta_mutation_sigma = 0.0;  // the rates are given
  Genome genome = lineage.front().individual.genome;
  Windows windows;
  for (size_t position = 0; position < lineage.size(); ++position)
  {
    if (position > 0)
    {
      genome.mutation_rate = lineage[position].individual.genome.mutation_rate;
      RandomStream random(settings.seed, settings.arm(), trial, static_cast<int64_t>(position), replicate,
                          RandomPurpose::NEUTRAL_LINEAGE);
      genome = mutate(genome, drift, layout, random);
    }
    windows.morphology.push_back(morphologyWindow(genome.program, layout));
    windows.control.push_back(controlWindow(genome.program, layout));
  }
  return windows;
}
}  // namespace devo_evo
