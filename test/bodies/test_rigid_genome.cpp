// How genomes of the rigid quadruped come to be and mutate.

#include "devo_evo/bodies/bodies.h"
#include "devo_evo/evolution/genome.h"

#include <gtest/gtest.h>

#include <cmath>

namespace devo_evo::test
{
namespace
{
const std::shared_ptr<const Body> BODY = makeRigidBody(RigidBodySettings());

EvolutionSettings settingsOf(Treatment treatment)
{
  EvolutionSettings settings;
  settings.treatment = treatment;
  return settings;
}

Genome founder(const EvolutionSettings& settings, int64_t id = 0)
{
  return bornGenome(settings, BODY->layout(settings), 1, 0, id, nullptr);
}

/// How many numbers differ.
int64_t changes(const std::vector<double>& before, const std::vector<double>& after)
{
  int64_t count = 0;
  for (size_t i = 0; i < before.size(); ++i)
  {
    count += before[i] != after[i] ? 1 : 0;
  }
  return count;
}

/// Mean numbers that a reproduction changes in the arrays of morphology and of control that evolve.
struct Changes
{
  double morphology = 0.0;
  double control = 0.0;
  double nothing = 0.0;  ///< share of reproductions
};

Changes countChanges(Treatment treatment, int64_t reproductions)
{
  const EvolutionSettings settings = settingsOf(treatment);
  const TreatmentSpec& spec = specOf(treatment);
  const GenomeLayout layout = BODY->layout(settings);
  const Genome parent = founder(settings);
  Changes mean;
  for (int64_t id = 1; id <= reproductions; ++id)
  {
    const DevelopmentalProgram child = bornGenome(settings, layout, 1, 1, id, &parent).program;
    const int64_t morphology =
        changes(parent.program.morphology_initial, child.morphology_initial) +
        (spec.body_develops ? changes(parent.program.morphology_final, child.morphology_final) : 0);
    const int64_t control = changes(parent.program.control_initial, child.control_initial) +
                            (spec.control_develops ? changes(parent.program.control_final, child.control_final) : 0);
    mean.morphology += static_cast<double>(morphology) / static_cast<double>(reproductions);
    mean.control += static_cast<double>(control) / static_cast<double>(reproductions);
    mean.nothing += (morphology + control == 0 ? 1.0 : 0.0) / static_cast<double>(reproductions);
  }
  return mean;
}

TEST(RigidGenome, AReproductionChangesOneNumberOfEachArrayOnAverage)
{
  constexpr int64_t reproductions = 40000;
  for (const TreatmentSpec& spec : TREATMENTS)
  {
    const Changes mean = countChanges(spec.treatment, reproductions);
    EXPECT_NEAR(mean.morphology, 1.0, 0.025) << spec.name;  // five standard errors of a binomial count
    EXPECT_NEAR(mean.control, 1.0, 0.025) << spec.name;
    const double legs = spec.body_develops ? 8.0 : 4.0, weights = spec.control_develops ? 16.0 : 8.0;
    const double nothing = std::pow(1.0 - 1.0 / legs, legs) * std::pow(1.0 - 1.0 / weights, weights);
    EXPECT_NEAR(mean.nothing, nothing, 0.01) << spec.name;
  }
}

TEST(RigidGenome, FoundersFillTheRangesEvenly)
{
  const EvolutionSettings settings = settingsOf(Treatment::EVO_DEVO);
  double length = 0.0, square = 0.0, weight = 0.0;
  constexpr int64_t founders = 5000;
  for (int64_t id = 0; id < founders; ++id)
  {
    const DevelopmentalProgram program = founder(settings, id).program;
    ASSERT_EQ(program.morphology_initial.size(), 4u);
    ASSERT_EQ(program.control_final.size(), 8u);
    const double value = program.morphology_final[3];
    length += value / founders;
    square += value * value / founders;
    weight += program.control_initial[7] / founders;
    BODY->validate(program);
  }
  EXPECT_NEAR(length, 0.5, 0.02);
  EXPECT_NEAR(square, 1.0 / 3.0, 0.02);
  EXPECT_NEAR(weight, 0.0, 0.04);
}

TEST(RigidGenome, WithoutDevelopmentFinalValuesAreTheInitialOnes)
{
  const EvolutionSettings settings = settingsOf(Treatment::EVO);
  Genome genome = founder(settings);
  for (int64_t id = 1; id < 200; ++id)
  {
    genome = bornGenome(settings, BODY->layout(settings), 1, id, id, &genome);
    EXPECT_EQ(genome.program.morphology_final, genome.program.morphology_initial);
    EXPECT_EQ(genome.program.control_final, genome.program.control_initial);
    validate(genome, settings, BODY->layout(settings));
  }
}

TEST(RigidGenome, MutantsStayWithinTheRangesAndHaveNoMutationRates)
{
  const EvolutionSettings settings = settingsOf(Treatment::EVO_DEVO);
  Genome genome = founder(settings);
  for (int64_t id = 1; id < 2000; ++id)
  {
    genome = bornGenome(settings, BODY->layout(settings), 1, id, id, &genome);
    ASSERT_NO_THROW(validate(genome, settings, BODY->layout(settings)));
  }
  EXPECT_TRUE(genome.mutation_rate.empty());
}

TEST(RigidGenome, WindowsAreSharesOfTheRanges)
{
  const GenomeLayout layout = BODY->layout(EvolutionSettings());
  DevelopmentalProgram program = {
    { 0, 0, 0, 0 }, { 1, 1, 0, 0 }, std::vector<double>(8, -1.0), std::vector<double>(8, 1.0)
  };
  EXPECT_EQ(morphologyWindow(program, layout), 0.5);
  EXPECT_EQ(controlWindow(program, layout), 1.0);
  program.control_final[0] = -1.0;
  EXPECT_EQ(controlWindow(program, layout), 0.875);
  program.control_final = program.control_initial;
  EXPECT_EQ(controlWindow(program, layout), 0.0);
  program.morphology_initial = program.morphology_final = { 0.5, 0.5, 0.5, 0.5 };
  EXPECT_EQ(morphologyWindow(program, layout), 0.0);
  program.morphology_final = { 0.5, 1.0, 0.0, 0.25 };  // (0 + 0.5 + 0.5 + 0.25) / 4
  EXPECT_DOUBLE_EQ(morphologyWindow(program, layout), 0.3125);
}

TEST(RigidGenome, WhatDoesNotFitIsRefusedByArrayIndexAndValue)
{
  const auto complaint = [](const DevelopmentalProgram& program) -> std::string
  {
    try
    {
      BODY->validate(program);
    }
    catch (const InvalidInput& error)
    {
      return error.what();
    }
    return "";
  };
  const DevelopmentalProgram sound = founder(settingsOf(Treatment::EVO_DEVO)).program;
  EXPECT_EQ(complaint(sound), "");
  DevelopmentalProgram program = sound;
  program.morphology_final[2] = -0.25;
  EXPECT_EQ(complaint(program), "leg_length_final[2] is -0.25; it must lie within 0 to 1");
  program = sound;
  program.control_initial[7] = 1.5;
  EXPECT_EQ(complaint(program), "weight_initial[7] is 1.5; it must lie within -1 to 1");
  program = sound;
  program.control_initial.pop_back();
  EXPECT_EQ(complaint(program), "weight_initial has 7 values; a rigid quadruped needs 8");
}

TEST(RigidGenome, TheArmTellsBodiesTreatmentsAndBaselinesApart)
{
  EvolutionSettings settings = settingsOf(Treatment::EVO);
  EXPECT_EQ(BODY->layout(settings).arm, "rigid/evo");
  settings.selection = Selection::RANDOM_SEARCH;
  EXPECT_EQ(BODY->layout(settings).arm, "rigid/evo/random_search");
}
}  // namespace
}  // namespace devo_evo::test
