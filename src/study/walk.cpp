#include "study/walk.h"

#include <algorithm>

namespace devo_evo
{
namespace
{
/// Of the traits that evolve, those of body or of control.
std::vector<TraitSpec> traitsIn(Scope space, const GenomeLayout& layout)
{
  const auto elsewhere = [space](const TraitSpec& trait)
  {
    const bool of_body = trait.values == &DevelopmentalProgram::morphology_initial ||
                         trait.values == &DevelopmentalProgram::morphology_final;
    return of_body != (space == Scope::BODY);
  };
  std::vector<TraitSpec> traits = evolvingTraits(layout);
  traits.erase(std::remove_if(traits.begin(), traits.end(), elsewhere), traits.end());
  return traits;
}

/// Uniform from the lowest rate there is to 1.
std::vector<double> drawRates(const EvolutionSettings& settings, size_t voxels, RandomStream& random)
{
  std::vector<double> rates(voxels, 1.0);
  for (double& rate : rates)
  {
    rate = settings.minimum_mutation_rate < 1.0 ? random.uniform(settings.minimum_mutation_rate, 1.0) : 1.0;
  }
  return rates;
}
}  // namespace

std::vector<WalkKind> walkKinds(Treatment treatment, bool with_removed, bool with_one_voxel)
{
  const TreatmentSpec& spec = specOf(treatment);
  std::vector<WalkKind> kinds;
  for (const Scope space : { Scope::CONTROL, Scope::BODY })
  {
    kinds.push_back({ space, false, false });
    if (with_one_voxel)
    {
      kinds.push_back({ space, false, true });
    }
    if (with_removed && (spec.body_develops || spec.control_develops))
    {
      kinds.push_back({ space, true, false });
    }
  }
  return kinds;
}

std::vector<Genome> walk(const WalkKind& kind, const Genome& champion, const EvolutionSettings& settings,
                         const Body& body, int64_t trial, int64_t number, int64_t steps)
{
  const std::string key =
      settings.arm() + "/walk/" + toString(kind.space) + "/" + kind.robot() + "/" + kind.mutationOperator();
  EvolutionSettings walker = settings;
  walker.mutation_rate.reset();
  Genome genome = champion;
  if (kind.removed)
  {
    walker.treatment = Treatment::EVO;
    genome.program = frozen(champion.program, Moment::BIRTH, Scope::BOTH);
  }
  const GenomeLayout layout = body.layout(walker);
  RandomStream rates(settings.seed, key, trial, 0, number, RandomPurpose::WALK_RATES);
  genome.mutation_rate = drawRates(settings, layout.morphology.size, rates);
  const std::vector<TraitSpec> traits = traitsIn(kind.space, layout);
  std::vector<Genome> genomes = { genome };
  for (int64_t step = 1; step <= steps; ++step)
  {
    RandomStream random(settings.seed, key, trial, step, number, RandomPurpose::WALK_STEP);
    genomes.push_back(kind.one_voxel ? mutateOneVoxel(genomes.back(), traits, layout, random)
                                     : mutateTraits(genomes.back(), traits, walker, layout, random));
  }
  return genomes;
}

int64_t voxelsChanged(const DevelopmentalProgram& before, const DevelopmentalProgram& after)
{
  int64_t changed = 0;
  for (size_t voxel = 0; voxel < before.control_initial.size(); ++voxel)
  {
    const auto differ = [&](std::vector<double> DevelopmentalProgram::*genes)
    { return (before.*genes)[voxel] != (after.*genes)[voxel]; };
    changed += differ(&DevelopmentalProgram::morphology_initial) || differ(&DevelopmentalProgram::morphology_final) ||
                       differ(&DevelopmentalProgram::control_initial) || differ(&DevelopmentalProgram::control_final)
                   ? 1
                   : 0;
  }
  return changed;
}
}  // namespace devo_evo
