#include "devo_evo/evolution/genome.h"
#include "evolution/settings_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>

using namespace devo_evo;

namespace
{
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
  std::vector<TraitSpec> traits = evolvingTraits(layoutOf(settings));
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
    Genome genome = bornGenome(settings, layoutOf(settings), 1, 0, 0, nullptr);
    for (int64_t id = 1; id <= 20; ++id)
    {
      validate(genome, settings, layoutOf(settings));
      EXPECT_EQ(spec.body_develops, genome.program.morphology_initial != genome.program.morphology_final) << spec.name;
      EXPECT_EQ(spec.control_develops, genome.program.control_initial != genome.program.control_final) << spec.name;
      genome = bornGenome(settings, layoutOf(settings), 1, id, id, &genome);
    }
  }
}

TEST(PartialDevelopment, hasThreeTraits)
{
  const auto names = [](Treatment treatment)
  {
    std::string text;
    for (const TraitSpec& trait : evolvingTraits(layoutOf(settingsOf(treatment, Profile::PAPER))))
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
  const Genome genome = bornGenome(settingsOf(Treatment::EVO_DEVO, Profile::PAPER),
                                   layoutOf(settingsOf(Treatment::EVO_DEVO, Profile::PAPER)), 1, 0, 0, nullptr);
  for (const Treatment treatment : { Treatment::EVO_DEVO_BODY, Treatment::EVO_DEVO_CONTROL })
  {
    EXPECT_THROW(
        validate(genome, settingsOf(treatment, Profile::PAPER), layoutOf(settingsOf(treatment, Profile::PAPER))),
        InvalidInput);
  }
}

TEST(MutationOfSomeTraits, leavesTheOthersAsTheyAre)
{
  const EvolutionSettings settings = settingsOf(Treatment::EVO_DEVO, Profile::PAPER, 1.0);
  const Genome parent = bornGenome(settings, layoutOf(settings), 1, 0, 0, nullptr);
  const std::vector<TraitSpec> phases = traitsNamed(settings, "phase");
  for (int64_t step = 0; step < 20; ++step)
  {
    RandomStream random = stream(step);
    const Genome child = mutateTraits(parent, phases, settings, layoutOf(settings), random);
    EXPECT_EQ(parent.program.morphology_initial, child.program.morphology_initial);
    EXPECT_EQ(parent.program.morphology_final, child.program.morphology_final);
    EXPECT_FALSE(child.program == parent.program);
  }
}

TEST(MutationOfOneVoxel, changesOnePhaseOrOneSizeAndItsImage)
{
  const EvolutionSettings settings = settingsOf(Treatment::EVO_DEVO, Profile::PAPER);
  const Genome parent = bornGenome(settings, layoutOf(settings), 1, 0, 0, nullptr);
  for (int64_t step = 0; step < 50; ++step)
  {
    RandomStream random = stream(step);
    const DevelopmentalProgram phases =
        mutateOneVoxel(parent, traitsNamed(settings, "phase"), layoutOf(settings), random).program;
    EXPECT_EQ(1, differences(parent.program.control_initial, phases.control_initial) +
                     differences(parent.program.control_final, phases.control_final));
    const Genome sizes = mutateOneVoxel(parent, traitsNamed(settings, "size"), layoutOf(settings), random);
    EXPECT_EQ(2, differences(parent.program.morphology_initial, sizes.program.morphology_initial) +
                     differences(parent.program.morphology_final, sizes.program.morphology_final));
    EXPECT_EQ(parent.mutation_rate, sizes.mutation_rate);
    validate(sizes, settings, layoutOf(settings));
  }
}
