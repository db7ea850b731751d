#include "study/mutation_count.h"

#include "devo_evo/evolution/genome.h"
#include "study/walk.h"

#include <cmath>

namespace devo_evo
{
namespace
{
/// Sums that are exact.
class Counter
{
public:
  void add(int64_t value)
  {
    ++count_;
    sum_ += value;
    squares_ += value * value;
  }

  Spread spread() const
  {
    const double n = static_cast<double>(count_);
    const double mean = static_cast<double>(sum_) / n;
    const double deviations = static_cast<double>(squares_) - mean * static_cast<double>(sum_);
    return { mean, std::sqrt(std::max(0.0, deviations) / (n - 1.0)) };
  }

private:
  int64_t count_ = 0;
  int64_t sum_ = 0;
  int64_t squares_ = 0;
};

int64_t genesChanged(const Genome& parent, const Genome& child, const std::vector<TraitSpec>& traits)
{
  int64_t changed = 0;
  for (const TraitSpec& trait : traits)
  {
    const std::vector<double>& before = parent.program.*trait.values;
    const std::vector<double>& after = child.program.*trait.values;
    for (size_t voxel = 0; voxel < before.size(); ++voxel)
    {
      changed += before[voxel] != after[voxel] ? 1 : 0;
    }
  }
  return changed;
}
}  // namespace

MutationCount countMutations(const EvolutionSettings& settings, const Body& body, int64_t reproductions)
{
  // Trials are numbered from 1. A random genome lies on no bound, so that every mutation changes something.
  constexpr int64_t no_trial = 0;
  const GenomeLayout layout = body.layout(settings);
  const Genome parent = bornGenome(settings, layout, no_trial, 0, 0, nullptr);
  const std::vector<TraitSpec> traits = evolvingTraits(layout);
  Counter voxels, genes;
  for (int64_t reproduction = 0; reproduction < reproductions; ++reproduction)
  {
    RandomStream random(settings.seed, settings.arm(), no_trial, 0, reproduction, RandomPurpose::MUTATION_COUNT);
    const Genome child = mutate(parent, settings, layout, random);
    voxels.add(voxelsChanged(parent.program, child.program));
    genes.add(genesChanged(parent, child, traits));
  }
  return { voxels.spread(), genes.spread() };
}
}  // namespace devo_evo
