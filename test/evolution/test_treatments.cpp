#include "devo_evo/evolution/genome.h"
#include "evolution/settings_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>

using namespace devo_evo;

namespace
{
const Lattice LATTICE(4, 4, 3);

RandomStream stream(int64_t step)
{
  return RandomStream(1, "walk", 0, step, 0, RandomPurpose::WALK_STEP);
}

/// How many values differ.
int differences(const std::vector<double>& a, const std::vector<double>& b)
{
  return static_cast<int>(std::inner_product(a.begin(), a.end(), b.begin(), size_t{ 0 }, std::plus<>(),
                                             [](double x, double y) { return x != y ? size_t{ 1 } : size_t{ 0 }; }));
}

std::vector<TraitSpec> traitsNamed(const EvolutionSettings& settings, const std::string& start)
{
  std::vector<TraitSpec> traits = evolvingTraits(settings);
  traits.erase(std::remove_if(traits.begin(), traits.end(),
                              [&](const TraitSpec& trait) { return trait.name.rfind(start, 0) != 0; }),
               traits.end());
  return traits;
}
}  // namespace

TEST(PartialDevelopment, leavesWhatDoesNotDevelopAsItWasAtBirth)
{
  for (const TreatmentSpec& spec : TREATMENTS)
  {
    const EvolutionSettings settings = settingsOf(spec.treatment, Profile::PAPER, 0.5);
    Genome genome = bornGenome(settings, LATTICE, 1, 0, 0, nullptr);
    for (int64_t id = 1; id <= 20; ++id)
    {
      validate(genome, settings, SoftBodySettings());
      EXPECT_EQ(spec.body_develops, genome.program.size_gene_initial != genome.program.size_gene_final) << spec.name;
      EXPECT_EQ(spec.control_develops, genome.program.phase_initial != genome.program.phase_final) << spec.name;
      genome = bornGenome(settings, LATTICE, 1, id, id, &genome);
    }
  }
}

TEST(PartialDevelopment, hasThreeTraits)
{
  const auto names = [](Treatment treatment)
  {
    std::string text;
    for (const TraitSpec& trait : evolvingTraits(settingsOf(treatment, Profile::PAPER)))
    {
      text += trait.name + " ";
    }
    return text;
  };
  EXPECT_EQ("size_gene_initial size_gene_final phase_initial ", names(Treatment::EVO_DEVO_BODY));
  EXPECT_EQ("size_gene_initial phase_initial phase_final ", names(Treatment::EVO_DEVO_CONTROL));
}

TEST(PartialDevelopment, refusesAGenomeThatDevelopsInWhatDoesNot)
{
  const Genome genome = bornGenome(settingsOf(Treatment::EVO_DEVO, Profile::PAPER), LATTICE, 1, 0, 0, nullptr);
  for (const Treatment treatment : { Treatment::EVO_DEVO_BODY, Treatment::EVO_DEVO_CONTROL })
  {
    EXPECT_THROW(validate(genome, settingsOf(treatment, Profile::PAPER), SoftBodySettings()), InvalidInput);
  }
}

TEST(MutationOfSomeTraits, leavesTheOthersAsTheyAre)
{
  const EvolutionSettings settings = settingsOf(Treatment::EVO_DEVO, Profile::PAPER, 1.0);
  const Genome parent = bornGenome(settings, LATTICE, 1, 0, 0, nullptr);
  const std::vector<TraitSpec> phases = traitsNamed(settings, "phase");
  for (int64_t step = 0; step < 20; ++step)
  {
    RandomStream random = stream(step);
    const Genome child = mutateTraits(parent, phases, settings, LATTICE, random);
    EXPECT_EQ(parent.program.size_gene_initial, child.program.size_gene_initial);
    EXPECT_EQ(parent.program.size_gene_final, child.program.size_gene_final);
    EXPECT_FALSE(child.program == parent.program);
  }
}

TEST(MutationOfOneVoxel, changesOnePhaseOrOneSizeAndItsImage)
{
  const EvolutionSettings settings = settingsOf(Treatment::EVO_DEVO, Profile::PAPER);
  const Genome parent = bornGenome(settings, LATTICE, 1, 0, 0, nullptr);
  for (int64_t step = 0; step < 50; ++step)
  {
    RandomStream random = stream(step);
    const DevelopmentalProgram phases =
        mutateOneVoxel(parent, traitsNamed(settings, "phase"), settings, LATTICE, random).program;
    EXPECT_EQ(1, differences(parent.program.phase_initial, phases.phase_initial) +
                     differences(parent.program.phase_final, phases.phase_final));
    const Genome sizes = mutateOneVoxel(parent, traitsNamed(settings, "size"), settings, LATTICE, random);
    EXPECT_EQ(2, differences(parent.program.size_gene_initial, sizes.program.size_gene_initial) +
                     differences(parent.program.size_gene_final, sizes.program.size_gene_final));
    EXPECT_EQ(parent.mutation_rate, sizes.mutation_rate);
    validate(sizes, settings, SoftBodySettings());
  }
}
