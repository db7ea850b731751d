#include "study/heterochrony.h"

#include "devo_evo/evolution/genome.h"
#include "evolution/settings_of.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace devo_evo;

namespace
{
/// Sizes of two voxels; phases do not matter.
DevelopmentalProgram sizes(const std::vector<double>& initial, const std::vector<double>& final)
{
  return { initial, final, { 0.0, 0.0 }, { 0.0, 0.0 } };
}

/// A lineage under selection of nothing, mutated by the operator.
std::vector<ArchivedIndividual> someLineage(const EvolutionSettings& settings, int64_t steps)
{
  std::vector<ArchivedIndividual> lineage(1);
  lineage[0].individual.genome = bornGenome(settings, layoutOf(settings), 1, 0, 0, nullptr);
  for (int64_t step = 1; step <= steps; ++step)
  {
    ArchivedIndividual child;
    child.individual.genome =
        bornGenome(settings, layoutOf(settings), 1, step, step, &lineage.back().individual.genome);
    lineage.push_back(child);
  }
  return lineage;
}
}  // namespace

TEST(Progenesis, isInitialValuesThatMoveTowardsFinalOnes)
{
  // Of a window of (1 + 1) / 4 the first voxel's initial value closes 0.6 / 4.
  const WindowClosing closing =
      morphologyClosing(sizes({ 0.0, -0.5 }, { 1.0, 0.5 }), sizes({ 0.6, -0.5 }, { 1.0, 0.5 }));
  EXPECT_DOUBLE_EQ(closing.initial_towards_final, 0.15);
  EXPECT_DOUBLE_EQ(closing.final_towards_initial, 0.0);
}

TEST(Neoteny, isFinalValuesThatMoveTowardsInitialOnes)
{
  const WindowClosing closing =
      morphologyClosing(sizes({ 0.0, -0.5 }, { 1.0, 0.5 }), sizes({ 0.0, -0.5 }, { 1.0, -0.1 }));
  EXPECT_DOUBLE_EQ(closing.initial_towards_final, 0.0);
  EXPECT_DOUBLE_EQ(closing.final_towards_initial, 0.15);
}

TEST(Heterochrony, isNegativeWhereTheWindowOpens)
{
  const WindowClosing closing =
      morphologyClosing(sizes({ 0.0, 0.0 }, { 0.0, 0.0 }), sizes({ -0.4, 0.0 }, { 0.0, 0.0 }));
  EXPECT_DOUBLE_EQ(closing.initial_towards_final, -0.1);
  EXPECT_DOUBLE_EQ(closing.final_towards_initial, 0.0);
}

TEST(Heterochrony, sharesWhatBothEndsDoTogetherEqually)
{
  // Both ends move by 0.5 in the same direction: the window stays, and neither goes first.
  const WindowClosing together =
      morphologyClosing(sizes({ 0.0, 0.0 }, { 0.2, 0.0 }), sizes({ 0.5, 0.0 }, { 0.7, 0.0 }));
  EXPECT_NEAR(together.initial_towards_final + together.final_towards_initial, 0.0, 1e-15);
  // Initial first: 0.2 -> 0.3 -> 0.2, closes -0.1; last: 0.2 -> 0.7 -> 0.2, closes 0.5; on average 0.2 of 4.
  EXPECT_NEAR(together.initial_towards_final, 0.05, 1e-15);
}

TEST(Heterochrony, addsUpToTheChangeOfTheWindow)
{
  const EvolutionSettings settings = settingsOf(Treatment::EVO_DEVO, Profile::PAPER, 0.5);
  const std::vector<ArchivedIndividual> lineage = someLineage(settings, 30);
  for (size_t step = 1; step < lineage.size(); ++step)
  {
    const DevelopmentalProgram& parent = lineage[step - 1].individual.genome.program;
    const DevelopmentalProgram& child = lineage[step].individual.genome.program;
    const WindowClosing body = morphologyClosing(parent, child), control = controlClosing(parent, child, 0.25);
    EXPECT_NEAR(body.initial_towards_final + body.final_towards_initial,
                morphologyWindow(parent, layoutOf(EvolutionSettings())) -
                    morphologyWindow(child, layoutOf(EvolutionSettings())),
                1e-14);
    EXPECT_NEAR(
        control.initial_towards_final + control.final_towards_initial,
        controlWindow(parent, layoutOf(EvolutionSettings())) - controlWindow(child, layoutOf(EvolutionSettings())),
        1e-14);
  }
}

TEST(NeutralLineages, beginWithTheFounderAndAreAsLong)
{
  const EvolutionSettings settings = settingsOf(Treatment::EVO_DEVO, Profile::PAPER);
  const std::vector<ArchivedIndividual> lineage = someLineage(settings, 12);
  const DevelopmentalProgram& founder = lineage.front().individual.genome.program;
  const Windows windows = neutralWindows(lineage, settings, paperBody(), 1, 1);
  ASSERT_EQ(windows.morphology.size(), 13u);
  ASSERT_EQ(windows.control.size(), 13u);
  EXPECT_EQ(windows.morphology.front(), morphologyWindow(founder, layoutOf(settings)));
  EXPECT_EQ(windows.control.front(), controlWindow(founder, layoutOf(settings)));
  EXPECT_EQ(windows.control, neutralWindows(lineage, settings, paperBody(), 1, 1).control);
  EXPECT_NE(windows.control, neutralWindows(lineage, settings, paperBody(), 1, 2).control);
}

TEST(NeutralLineages, haveTheMutationRatesOfTheRealOne)
{
  EvolutionSettings settings = settingsOf(Treatment::EVO_DEVO, Profile::PAPER);
  settings.minimum_mutation_rate = 0.0;
  std::vector<ArchivedIndividual> lineage = someLineage(settings, 4);
  for (size_t step = 0; step < lineage.size(); ++step)
  {
    lineage[step].individual.genome.mutation_rate.assign(48, step == 3 ? 1.0 : 0.0);
  }
  const Windows windows = neutralWindows(lineage, settings, paperBody(), 1, 1);
  const auto moved = [&](size_t step)
  {
    return windows.morphology[step] != windows.morphology[step - 1] ||
           windows.control[step] != windows.control[step - 1];
  };
  EXPECT_FALSE(moved(1) || moved(2) || moved(4));
  EXPECT_TRUE(moved(3));
}

TEST(NeutralLineages, riseFromOneThirdToAboutPointFourFour)
{
  // Uniform values are 1/3 of the range apart; values that drift pile up at the limits (docs/evolution.md).
  const EvolutionSettings settings = settingsOf(Treatment::EVO_DEVO, Profile::PAPER, 0.5);
  const std::vector<ArchivedIndividual> lineage = someLineage(settings, 60);
  double first = 0.0, last = 0.0;
  constexpr int replicates = 60;
  for (int64_t replicate = 1; replicate <= replicates; ++replicate)
  {
    const Windows windows = neutralWindows(lineage, settings, paperBody(), 1, replicate);
    first += windows.control.front() / replicates;
    last += windows.control.back() / replicates;
  }
  EXPECT_NEAR(first, 1.0 / 3, 0.1);  // one founder
  EXPECT_NEAR(last, 0.44, 0.02);
}
