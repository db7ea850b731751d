#include "study/walk.h"

#include "evolution/settings_of.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace devo_evo;

namespace
{
Genome founder(const EvolutionSettings& settings)
{
  return bornGenome(settings, layoutOf(settings), 1, 0, 0, nullptr);
}

std::vector<Genome> walkOf(const WalkKind& kind, Treatment treatment, int64_t number = 1, int64_t steps = 20)
{
  const EvolutionSettings settings = settingsOf(treatment, Profile::PAPER);
  return walk(kind, founder(settings), settings, paperBody(), 1, number, steps);
}
}  // namespace

TEST(Walk, changesItsOwnSpaceOnly)
{
  for (const Treatment treatment : { Treatment::EVO, Treatment::EVO_DEVO, Treatment::EVO_DEVO_CONTROL })
  {
    for (const bool one_voxel : { false, true })
    {
      const std::vector<Genome> control = walkOf({ Scope::CONTROL, false, one_voxel }, treatment);
      const std::vector<Genome> body = walkOf({ Scope::BODY, false, one_voxel }, treatment);
      EXPECT_EQ(control.size(), 21u);
      EXPECT_EQ(control.front().program.morphology_initial, control.back().program.morphology_initial);
      EXPECT_EQ(control.front().program.morphology_final, control.back().program.morphology_final);
      EXPECT_NE(control.front().program.control_initial, control.back().program.control_initial);
      EXPECT_EQ(body.front().program.control_initial, body.back().program.control_initial);
      EXPECT_EQ(body.front().program.control_final, body.back().program.control_final);
      EXPECT_NE(body.front().program.morphology_initial, body.back().program.morphology_initial);
      const EvolutionSettings settings = settingsOf(treatment, Profile::PAPER);
      validate(control.back(), settings, layoutOf(settings));
      validate(body.back(), settings, layoutOf(settings));
    }
  }
}

TEST(Walk, startsWithTheChampionAndRatesBetweenOne48thAndOne)
{
  const EvolutionSettings settings = settingsOf(Treatment::EVO_DEVO, Profile::PAPER);
  double sum = 0.0;
  for (int64_t number = 1; number <= 20; ++number)
  {
    const Genome start = walkOf({ Scope::CONTROL, false, false }, Treatment::EVO_DEVO, number, 0).front();
    EXPECT_EQ(start.program, founder(settings).program);
    ASSERT_EQ(start.mutation_rate.size(), 48u);
    for (const double rate : start.mutation_rate)
    {
      EXPECT_GE(rate, 1.0 / 48);
      EXPECT_LT(rate, 1.0);
      sum += rate;
    }
  }
  EXPECT_NEAR(sum / (20 * 48), (1.0 / 48 + 1.0) / 2, 0.04);  // over four standard deviations
}

TEST(Walk, changesAboutHalfOfAllVoxelsAStepIfRatesAreRedrawn)
{
  // Mean rate 0.51, one or two of the two traits of control: 0.51 * 48 = 24.5 of one, 27 voxels in all if two are
  // mutated a quarter of the time.
  double changed = 0.0;
  for (int64_t number = 1; number <= 100; ++number)
  {
    const std::vector<Genome> genomes = walkOf({ Scope::CONTROL, false, false }, Treatment::EVO_DEVO, number, 1);
    changed += static_cast<double>(voxelsChanged(genomes[0].program, genomes[1].program)) / 100;
  }
  EXPECT_NEAR(changed, 26.5, 2.5);
}

TEST(Walk, ofOneVoxelChangesAtMostOneVoxelOrAPairAStep)
{
  for (const Scope space : { Scope::CONTROL, Scope::BODY })
  {
    const std::vector<Genome> genomes = walkOf({ space, false, true }, Treatment::EVO_DEVO, 1, 50);
    int64_t all = 0;
    for (size_t step = 1; step < genomes.size(); ++step)
    {
      const int64_t changed = voxelsChanged(genomes[step - 1].program, genomes[step].program);
      EXPECT_LE(changed, space == Scope::BODY ? 2 : 1);
      all += changed;
    }
    EXPECT_GT(all, 25);  // now and then a value stays on its bound
  }
}

TEST(Walk, ofARemovedChampionNeverDevelops)
{
  const std::vector<Genome> genomes = walkOf({ Scope::BODY, true, false }, Treatment::EVO_DEVO);
  EXPECT_EQ(genomes.front().program.morphology_initial,
            founder(settingsOf(Treatment::EVO_DEVO, Profile::PAPER)).program.morphology_initial);
  const EvolutionSettings settings = settingsOf(Treatment::EVO, Profile::PAPER);
  for (const Genome& genome : genomes)
  {
    validate(genome, settings, layoutOf(settings));
  }
}

TEST(Walk, isAPureFunctionWhoseLengthChangesNoStep)
{
  const WalkKind kind = { Scope::CONTROL, false, false };
  const std::vector<Genome> shorter = walkOf(kind, Treatment::EVO_DEVO, 3, 10);
  const std::vector<Genome> longer = walkOf(kind, Treatment::EVO_DEVO, 3, 30);
  EXPECT_TRUE(std::equal(shorter.begin(), shorter.end(), longer.begin()));
  EXPECT_FALSE(longer[1] == walkOf(kind, Treatment::EVO_DEVO, 4, 30)[1]);
}

TEST(Walks, ofAnEvoChampionHaveNothingToRemove)
{
  EXPECT_EQ(walkKinds(Treatment::EVO, true, true).size(), 4u);
  EXPECT_EQ(walkKinds(Treatment::EVO_DEVO, true, true).size(), 6u);
  EXPECT_EQ(walkKinds(Treatment::EVO_DEVO, false, false).size(), 2u);
}

TEST(VoxelsChanged, countsAVoxelOnceHoweverManyOfItsGenesChange)
{
  const DevelopmentalProgram before = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } };
  const DevelopmentalProgram after = { { 0, 1, 0 }, { 0, 1, 0 }, { 0, 0, 0 }, { 0, 0, 1 } };
  EXPECT_EQ(voxelsChanged(before, before), 0);
  EXPECT_EQ(voxelsChanged(before, after), 2);
}
