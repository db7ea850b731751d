// Growth, development and actuation of a voxel's resting length, and its guards (docs/physics.md 5). Seen through
// simulations of single voxels, whose resting length follows from the time alone.
#include "soft_body/hand_made_body.h"
#include "soft_body/robots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace devo_evo;

namespace
{
constexpr double L = 0.01;
constexpr double SETTLING = 0.5;
constexpr double REFERENCE_TWO_PI = 6.2831850051879883;

SoftBodySettings oneVoxel()
{
  SoftBodySettings settings;
  settings.grid_x = settings.grid_y = settings.grid_z = 1;
  settings.lifetime = 1.0;
  return settings;
}

/// One voxel's genes: size at birth and at the end, phase at birth and at the end.
DevelopmentalProgram genes(double size_initial, double size_final, double phase_initial = 0.0, double phase_final = 0.0)
{
  return { { size_initial }, { size_final }, { phase_initial }, { phase_final } };
}

/// The voxel's scale after each step, and the simulator time at which that step began.
struct Growth
{
  std::vector<double> time;
  std::vector<double> scale;
};

Growth grow(const SoftBodySettings& settings, const DevelopmentalProgram& program)
{
  Growth growth;
  const std::unique_ptr<Simulation> simulation = makeSimulation(settings, { program }, InstructionSet::SCALAR);
  while (!simulation->finished())
  {
    growth.time.push_back(simulation->time());
    simulation->step();
    growth.scale.push_back(simulation->voxel(0, 0).scale);
  }
  return growth;
}

/// The formulas of docs/physics.md 5 before the guards, with the C library's sine.
double unguardedScale(const SoftBodySettings& settings, const DevelopmentalProgram& program, double time)
{
  const double at_birth = L * (1.0 + 0.75 * program.morphology_initial[0]);
  const double at_end = L * (1.0 + 0.75 * program.morphology_final[0]);
  if (time < SETTLING)
  {
    return L + std::min(1.0, 2.0 * time / SETTLING) * (at_birth - L);
  }
  const double age = std::min((time - SETTLING) / settings.lifetime, 1.0);
  const double size = at_birth + age * (at_end - at_birth);
  const double phase = program.control_initial[0] + age * (program.control_final[0] - program.control_initial[0]);
  const double stroke = std::min(1.0, (4.0 * size / L - 1.0) / 3.0);
  return size + settings.actuation_amplitude * L *
                    std::sin(REFERENCE_TWO_PI * (settings.actuation_frequency * time + phase)) * stroke;
}

void expectUnguarded(const SoftBodySettings& settings, const DevelopmentalProgram& program)
{
  const Growth growth = grow(settings, program);
  for (size_t i = 0; i < growth.scale.size(); ++i)
  {
    ASSERT_NEAR(unguardedScale(settings, program, growth.time[i]), growth.scale[i], 2e-17) << growth.time[i] << " s";
  }
}
}  // namespace

// ---- before birth ------------------------------------------------------------------------------------------------

TEST(Growth, isLinearToHalfTheSettlingTimeAndThenWaitsForBirth)
{
  SoftBodySettings settings = oneVoxel();
  settings.actuation_amplitude = 0.0;
  const Growth growth = grow(settings, genes(0.8, 0.8));  // to 1.6 cm
  for (size_t i = 0; i < growth.scale.size(); ++i)
  {
    const double expected = growth.time[i] < 0.25 ? L + growth.time[i] / 0.25 * 0.006 : 0.016;
    ASSERT_NEAR(expected, growth.scale[i], 1e-17) << growth.time[i] << " s";
  }
}

TEST(Growth, reachesAnyLengthOfTheRange)
{
  for (const double gene : { -0.999, -0.5, 0.0, 0.5, 1.0 })
  {
    SoftBodySettings settings = oneVoxel();
    settings.actuation_amplitude = 0.0;
    EXPECT_NEAR(L * (1.0 + 0.75 * gene), grow(settings, genes(gene, gene)).scale.back(), 1e-17);
  }
}

TEST(Growth, doesNotActuateBeforeBirth)
{
  const SoftBodySettings settings = oneVoxel();
  const Growth growth = grow(settings, genes(0.0, 0.0, 0.3, 0.3));
  for (size_t i = 0; i < growth.scale.size() && growth.time[i] < SETTLING; ++i)
  {
    ASSERT_EQ(L, growth.scale[i]) << growth.time[i] << " s";
  }
  EXPECT_NE(L, growth.scale.back());
}

// ---- life --------------------------------------------------------------------------------------------------------

TEST(Actuation, isASineOfTheSimulatorsTimeFromBirthOn)
{
  // 4 Hz and 14 % of 1 cm, on a voxel of nominal size: at t = 0.5625 s the sine is that of 2.25 cycles, its maximum.
  const SoftBodySettings settings = oneVoxel();
  expectUnguarded(settings, genes(0.0, 0.0));
  const Growth growth = grow(settings, genes(0.0, 0.0));
  const auto largest = std::max_element(growth.scale.begin(), growth.scale.end());
  EXPECT_NEAR(0.0114, *largest, 1e-9);
  EXPECT_NEAR(0.5625, growth.time[static_cast<size_t>(largest - growth.scale.begin())], 3e-4);
}

TEST(Actuation, isShiftedByThePhase)
{
  expectUnguarded(oneVoxel(), genes(0.0, 0.0, 0.25, 0.25));
  expectUnguarded(oneVoxel(), genes(0.2, 0.2, -0.7, -0.7));
}

TEST(Actuation, weakensLinearlyWithSizeBelowTheNominalOne)
{
  // xi = (4 x - 1) / 3: a third at half size (gene -2/3), none at a quarter (gene -1)
  const SoftBodySettings settings = oneVoxel();
  expectUnguarded(settings, genes(-2.0 / 3.0, -2.0 / 3.0));
  const std::vector<double> small = grow(settings, genes(-2.0 / 3.0, -2.0 / 3.0)).scale;
  EXPECT_NEAR(0.005 + 0.0014 / 3.0, *std::max_element(small.begin() + 2100, small.end()), 1e-8);
  EXPECT_NEAR(0.0025, grow(settings, genes(-1.0, -1.0)).scale.back(), 3e-6);
}

TEST(Actuation, isNotStrongerThanNominalInLargeVoxels)
{
  const std::vector<double> large = grow(oneVoxel(), genes(0.4, 0.4)).scale;
  EXPECT_NEAR(0.013 + 0.0014, *std::max_element(large.begin(), large.end()), 1e-8);
}

TEST(Development, changesSizeAndPhaseLinearlyOverTheLifetime)
{
  expectUnguarded(oneVoxel(), genes(-0.6, 0.7, 0.9, -0.8));
  SoftBodySettings settings = oneVoxel();
  settings.lifetime = 0.3;
  settings.actuation_frequency = 11.0;
  settings.actuation_amplitude = 0.05;
  expectUnguarded(settings, genes(0.9, -0.9, -1.0, 1.0));
}

TEST(Development, tellsTheRestingLengthWithoutActuation)
{
  const SoftBodySettings settings = oneVoxel();
  const std::unique_ptr<Simulation> simulation = makeSimulation(settings, { genes(0.8, -0.4) }, InstructionSet::SCALAR);
  while (!simulation->finished())
  {
    const double time = simulation->time();
    const double expected = time < 0.25       ? L + time / 0.25 * 0.006
                            : time < SETTLING ? 0.016
                                              : 0.016 + std::min(1.0, time - SETTLING) * (0.007 - 0.016);
    ASSERT_NEAR(expected, simulation->restingLength(0, 0), 1e-17) << time << " s";
    simulation->step();
  }
}

// ---- guards ------------------------------------------------------------------------------------------------------

TEST(UpperLimit, keepsTheLastLengthInsteadOfGrowingBeyond175Percent)
{
  const SoftBodySettings settings = oneVoxel();
  const DevelopmentalProgram program = genes(0.95, 0.95);  // 1.7125 cm +- 1.4 mm: the peak would be 1.8525 cm
  const Growth growth = grow(settings, program);
  int kept = 0;
  for (size_t i = 1; i < growth.scale.size(); ++i)
  {
    const double wanted = unguardedScale(settings, program, growth.time[i]);
    const bool beyond = wanted > growth.scale[i - 1] && wanted > 1.75 * L;
    kept += beyond ? 1 : 0;
    ASSERT_EQ(beyond, growth.scale[i] == growth.scale[i - 1] && growth.time[i] > SETTLING) << growth.time[i] << " s";
    ASSERT_NEAR(beyond ? growth.scale[i - 1] : wanted, growth.scale[i], 2e-17) << growth.time[i] << " s";
    ASSERT_LE(growth.scale[i], 1.75 * L);
  }
  EXPECT_GT(kept, 1000);
}

TEST(UpperLimit, letsALengthBeyondItShrink)
{
  // From 1.9 cm, set by hand, to 1.8 cm: beyond the limit, but not growing
  HandMadeBody voxel(weightlessSettings(1, 1, 1));
  voxel.setScale(0, 0.018);
  voxel.at(0, SCALE) = 0.019;
  voxel.step();
  EXPECT_NEAR(0.018, voxel.at(0, SCALE), 1e-17);
  voxel.at(0, SCALE) = 0.0178;  // growing beyond it: kept
  voxel.step();
  EXPECT_EQ(0.0178, voxel.at(0, SCALE));
}

TEST(LowerLimit, keepsTheLastLengthInsteadOfShrinkingBelow25Percent)
{
  HandMadeBody voxel(weightlessSettings(1, 1, 1));
  voxel.setScale(0, 0.0024);
  voxel.at(0, SCALE) = 0.00251;
  voxel.step();
  EXPECT_EQ(0.00251, voxel.at(0, SCALE));
  voxel.at(0, SCALE) = 0.0022;  // below it, but growing
  voxel.step();
  EXPECT_NEAR(0.0024, voxel.at(0, SCALE), 1e-17);
}

TEST(LowerLimit, stopsTheGrowthOfAGeneBelowMinusOneByRoundingOneStepEarly)
{
  // The length at birth is 0.25 L - 7.5e-10 m; the last step of growth before 0.25 s is the last above 0.25 L.
  const SoftBodySettings settings = oneVoxel();
  const Growth growth = grow(settings, genes(-1.0 - 1e-7, -1.0 - 1e-7));
  const int last = static_cast<int>(0.25 / settings.timeStep());
  const double expected = L - last * settings.timeStep() / 0.25 * 0.75 * L * (1.0 + 1e-7);
  EXPECT_GT(expected, 0.25 * L);
  EXPECT_NEAR(expected, growth.scale[static_cast<size_t>(last)], 1e-16);
  for (size_t i = static_cast<size_t>(last); i < growth.scale.size(); ++i)
  {
    ASSERT_EQ(growth.scale[static_cast<size_t>(last)], growth.scale[i]) << growth.time[i] << " s";
  }
}

TEST(LowerLimit, stopsAnInwardStrokeToo)
{
  // An amplitude of 1 (beyond what settings allow): half-size voxels would shrink to 0.5 L - L / 3 = 0.167 L
  SoftBodySettings settings = weightlessSettings(1, 1, 1);
  settings.actuation_amplitude = 1.0;
  HandMadeBody voxel(settings);
  voxel.setScale(0, 0.005);
  voxel.clock.born = true;
  double smallest = 1.0;
  for (int step = 0; step < 200; ++step)
  {
    voxel.clock.cycles = 0.5 + 0.005 * step;  // an inward stroke, then an outward one
    voxel.step();
    smallest = std::min(smallest, voxel.at(0, SCALE));
  }
  EXPECT_GE(smallest, 0.0025);
  EXPECT_LT(smallest, 0.00261);  // one step before: the stroke moves up to 0.105 mm a step here
  EXPECT_GT(voxel.at(0, SCALE), 0.0049);
}
