// Every result is the same to the last bit, whatever the instruction set, the lane, the batch-mates and the size of the
// batch (docs/physics.md, "Why results are the same everywhere").
#include "soft_body/hand_made_body.h"
#include "soft_body/robots.h"

#include "devo_evo/soft_body/text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

using namespace devo_evo;
using Eigen::Vector3d;

namespace
{
/// The fingerprint of this engine. It changes with any change of the arithmetic, be it in the last bit, and only then;
/// an experiment does not go on with another engine than it was begun with.
constexpr const char* ENGINE_FINGERPRINT = "a642026f3a4b66be";

bool sameBits(double a, double b)
{
  return std::memcmp(&a, &b, sizeof a) == 0;
}

void expectSame(const Evaluation& expected, const Evaluation& actual)
{
  EXPECT_EQ(expected.valid, actual.valid);
  EXPECT_EQ(hashToString(expected.state_hash), hashToString(actual.state_hash));
  EXPECT_TRUE(sameBits(expected.fitness, actual.fitness));
  EXPECT_TRUE(sameBits(expected.displacement_y_voxels, actual.displacement_y_voxels));
  EXPECT_TRUE(sameBits(expected.displacement_xy_voxels, actual.displacement_xy_voxels));
  EXPECT_EQ(expected.first_top_contact_since_birth_s, actual.first_top_contact_since_birth_s);
  EXPECT_EQ(expected.fell_over_since_birth_s, actual.fell_over_since_birth_s);
  EXPECT_TRUE(sameBits(expected.turns, actual.turns));
  EXPECT_TRUE(sameBits(expected.airborne_fraction, actual.airborne_fraction));
  EXPECT_EQ(expected.velocity_body_lengths_per_s, actual.velocity_body_lengths_per_s);
  ASSERT_EQ(expected.divergence.has_value(), actual.divergence.has_value());
  if (expected.divergence)
  {
    EXPECT_EQ(expected.divergence->step, actual.divergence->step);
    EXPECT_EQ(expected.divergence->bond, actual.divergence->bond);
    EXPECT_TRUE(sameBits(expected.divergence->strain, actual.divergence->strain));
  }
}

void expectSame(const std::vector<Evaluation>& expected, const std::vector<Evaluation>& actual)
{
  ASSERT_EQ(expected.size(), actual.size());
  for (size_t robot = 0; robot < expected.size(); ++robot)
  {
    SCOPED_TRACE(robot);
    expectSame(expected[robot], actual[robot]);
  }
}

/// Compares the robots' evaluations by every instruction set, and returns them.
std::vector<Evaluation> evaluateByAll(const SoftBodySettings& settings, const std::vector<DevelopmentalProgram>& robots)
{
  const std::vector<Evaluation> expected = evaluate(settings, robots, InstructionSet::SCALAR);
  for (const InstructionSet instruction_set : supportedInstructionSets())
  {
    SCOPED_TRACE(toString(instruction_set));
    expectSame(expected, evaluate(settings, robots, instruction_set));
  }
  return expected;
}

std::vector<DevelopmentalProgram> referenceRobots(std::initializer_list<size_t> indices)
{
  const std::vector<ReferenceGenome> genomes = referenceGenomes();
  std::vector<DevelopmentalProgram> robots;
  for (const size_t index : indices)
  {
    robots.push_back(genomes[index].program);
  }
  return robots;
}

/// Every kernel that this processor can run.
std::vector<std::pair<std::string, const Kernel*>> runnableKernels()
{
  std::vector<std::pair<std::string, const Kernel*>> kernels = { { "scalar", scalarKernel() } };
  if (isSupported(InstructionSet::AVX2))
  {
    kernels.emplace_back("scalar, fused", scalarFmaKernel());  // wants the same fused multiply-add
    kernels.emplace_back("avx2", avx2Kernel());
  }
  if (isSupported(InstructionSet::AVX512))
  {
    kernels.emplace_back("avx512", avx512Kernel());
  }
  return kernels;
}
}  // namespace

// ---- whole lives -------------------------------------------------------------------------------------------------

TEST(InstructionSets, agreeToTheLastBit)
{
  SoftBodySettings settings;
  settings.lifetime = 0.2;
  for (const Evaluation& evaluation : evaluateByAll(settings, scrambledRobots(settings, 11)))
  {
    EXPECT_TRUE(evaluation.valid);
  }
}

TEST(InstructionSets, agreeOnRobotsThatRollAndCollide)
{
  // The champion of the rollers turns over within its first second; its mates shuffle and bump into themselves
  SoftBodySettings settings;
  settings.lifetime = 1.0;
  const std::vector<DevelopmentalProgram> robots = referenceRobots({ 1, 35, 3, 34, 12 });
  const std::vector<Evaluation> evaluations = evaluateByAll(settings, robots);
  EXPECT_GT(evaluations[1].turns, 0.5);
  settings.self_collision = false;
  const std::vector<Evaluation> without_collisions = evaluate(settings, robots);
  EXPECT_NE(without_collisions[0].state_hash, evaluations[0].state_hash);
  EXPECT_NE(without_collisions[1].state_hash, evaluations[1].state_hash);
}

TEST(InstructionSets, agreeOnRobotsOfWhichSomeDiverge)
{
  // At 1.75 times critical damping with the longest step, bodies are on the verge: some diverge at once, some later,
  // some thrash on.
  SoftBodySettings settings;
  settings.time_step_fraction = 1.0;
  settings.bond_damping = 1.75;
  settings.lifetime = 0.5;
  const std::vector<DevelopmentalProgram> robots =
      referenceRobots({ 0, 2, 4, 9, 12, 14, 16, 20, 24, 26, 28, 30, 32, 35 });
  const std::vector<Evaluation> evaluations = evaluateByAll(settings, robots);
  const auto valid = std::count_if(evaluations.begin(), evaluations.end(), [](const Evaluation& e) { return e.valid; });
  EXPECT_GE(valid, 3);
  EXPECT_LE(valid, static_cast<std::ptrdiff_t>(robots.size()) - 3);
}

TEST(InstructionSets, agreeOnBodiesOfOtherSizes)
{
  for (const auto& [x, y, z] : { std::tuple{ 1, 1, 1 }, { 2, 1, 1 }, { 5, 3, 2 }, { 6, 6, 6 } })
  {
    SCOPED_TRACE(testing::Message() << x << "x" << y << "x" << z);
    SoftBodySettings settings;
    settings.grid_x = x;
    settings.grid_y = y;
    settings.grid_z = z;
    settings.lifetime = 0.05;
    evaluateByAll(settings, scrambledRobots(settings, 3));
  }
}

TEST(InstructionSets, agreeWithEveryOption)
{
  SoftBodySettings settings;
  settings.grid_x = 3;
  settings.grid_y = 3;
  settings.lifetime = 0.1;
  settings.sideways_bend_test = true;
  settings.actuation_amplitude = 0.5;
  settings.actuation_frequency = 9.0;
  settings.static_friction = 0.1;
  settings.dynamic_friction = 2.0;
  settings.voxel_size = 0.02;
  settings.density = 5e5;
  settings.poissons_ratio = 0.0;
  evaluateByAll(settings, scrambledRobots(settings, 9));
}

// ---- lanes and batches -------------------------------------------------------------------------------------------

TEST(Lanes, doNotMatterToARobot)
{
  SoftBodySettings settings;
  settings.lifetime = 0.05;
  const DevelopmentalProgram robot = scrambledRobot(settings, 99);
  for (const InstructionSet instruction_set : supportedInstructionSets())
  {
    const int lanes = laneCount(instruction_set);
    const Evaluation alone = evaluate(settings, { robot }, instruction_set).front();
    for (int lane = 0; lane < lanes; ++lane)
    {
      SCOPED_TRACE(toString(instruction_set) + ", lane " + toText(lane));
      std::vector<DevelopmentalProgram> batch = scrambledRobots(settings, lanes);
      batch[static_cast<size_t>(lane)] = robot;
      expectSame(alone, evaluate(settings, batch, instruction_set)[static_cast<size_t>(lane)]);
    }
  }
}

TEST(Lanes, mayBeEmpty)
{
  SoftBodySettings settings;
  settings.lifetime = 0.05;
  for (const InstructionSet instruction_set : supportedInstructionSets())
  {
    const int lanes = laneCount(instruction_set);
    const std::vector<DevelopmentalProgram> robots = scrambledRobots(settings, lanes);
    const std::vector<Evaluation> full = evaluate(settings, robots, instruction_set);
    for (int count = 1; count < lanes; ++count)
    {
      SCOPED_TRACE(toString(instruction_set) + ", " + toText(count) + " robots");
      expectSame({ full.begin(), full.begin() + count },
                 evaluate(settings, { robots.begin(), robots.begin() + count }, instruction_set));
    }
  }
}

TEST(Lanes, doNotFeelADivergedMate)
{
  // The mate is thrown apart by hand, which no genome does with default settings, with a NaN in one lane and an
  // infinite momentum in another; the rest goes on as if alone.
  SoftBodySettings settings;
  settings.grid_x = settings.grid_y = settings.grid_z = 3;
  const std::vector<DevelopmentalProgram> robots = scrambledRobots(settings, MAX_LANES);
  const auto place = [&robots](HandMadeBody& body, int lane, size_t robot)
  {
    for (int voxel = 0; voxel < 27; ++voxel)
    {
      const size_t i = static_cast<size_t>(voxel);
      body.setScale(voxel, 0.01 * (1.0 + 0.3 * robots[robot].morphology_initial[i]), lane);
      body.setVelocity(voxel, { robots[robot].control_initial[i], robots[robot].control_final[i], 0.0 }, lane);
    }
    const double not_a_number = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    body.at(13, POSITION, lane) = robot == 1 ? not_a_number : body.at(13, POSITION, lane);
    body.at(5, MOMENTUM + 1, lane) = robot == 2 ? infinity : body.at(5, MOMENTUM + 1, lane);
    body.at(26, POSITION + 2, lane) = robot == 3 ? 7.0 : body.at(26, POSITION + 2, lane);
  };
  const auto run = [](HandMadeBody& body)
  {
    body.clock.first_step = true;
    for (int step = 0; step < 50; ++step)
    {
      body.step();
      body.clock.first_step = false;
    }
  };
  for (const auto& [name, kernel] : runnableKernels())
  {
    SCOPED_TRACE(name);
    HandMadeBody batch(settings, *kernel);
    for (int lane = 0; lane < kernel->lanes; ++lane)
    {
      place(batch, lane, static_cast<size_t>(lane));
    }
    run(batch);
    for (int lane = 0; lane < kernel->lanes; ++lane)
    {
      SCOPED_TRACE(lane);
      HandMadeBody alone(settings);
      place(alone, 0, static_cast<size_t>(lane));
      run(alone);
      const bool diverged = lane >= 1 && lane <= 3;
      ASSERT_EQ(diverged, (alone.state().diverged & 1u) != 0);
      ASSERT_EQ(diverged, (batch.state().diverged >> lane & 1u) != 0);
      if (diverged)
      {
        EXPECT_EQ(alone.state().diverged_bond[0], batch.state().diverged_bond[lane]);
        EXPECT_EQ(std::isnan(alone.state().diverged_strain[0]), std::isnan(batch.state().diverged_strain[lane]));
        continue;
      }
      for (int voxel = 0; voxel < 27; ++voxel)
      {
        ASSERT_EQ(alone.staticFriction(voxel), batch.staticFriction(voxel, lane));
        for (int field = POSITION; field <= SCALE; ++field)
        {
          ASSERT_EQ(alone.at(voxel, field), batch.at(voxel, field, lane)) << "voxel " << voxel << ", field " << field;
        }
      }
    }
  }
}

// ---- evaluate ----------------------------------------------------------------------------------------------------

TEST(Evaluate, takesAnyNumberOfRobots)
{
  SoftBodySettings settings;
  settings.lifetime = 0.01;
  EXPECT_TRUE(evaluate(settings, {}).empty());
  const std::vector<DevelopmentalProgram> robots = scrambledRobots(settings, 19);
  const std::vector<Evaluation> evaluations = evaluate(settings, robots);
  ASSERT_EQ(19u, evaluations.size());
  expectSame(evaluate(settings, { robots[17] }).front(), evaluations[17]);
}

TEST(Evaluate, isAPureFunction)
{
  SoftBodySettings settings;
  settings.lifetime = 0.05;
  const std::vector<DevelopmentalProgram> robots = scrambledRobots(settings, 3);
  expectSame(evaluate(settings, robots), evaluate(settings, robots));
}

TEST(Evaluate, stopsWhenTold)
{
  const SoftBodySettings settings;
  const std::atomic<bool> stop = true;
  EXPECT_THROW(evaluate(settings, { scrambledRobot(settings, 1) }, bestInstructionSet(), &stop), EvaluationAbandoned);
}

TEST(Evaluate, goesOnUnlessTold)
{
  SoftBodySettings settings;
  settings.lifetime = 0.01;
  const std::atomic<bool> stop = false;
  EXPECT_TRUE(evaluate(settings, { scrambledRobot(settings, 1) }, bestInstructionSet(), &stop).front().valid);
}

// ---- fingerprint -------------------------------------------------------------------------------------------------

TEST(EngineFingerprint, isTheSameInEveryInstructionSet)
{
  const uint64_t expected = engineFingerprint(InstructionSet::SCALAR);
  for (const InstructionSet instruction_set : supportedInstructionSets())
  {
    EXPECT_EQ(expected, engineFingerprint(instruction_set)) << toString(instruction_set);
  }
}

TEST(EngineFingerprint, isTheOneNotedHere)
{
  EXPECT_EQ(ENGINE_FINGERPRINT, hashToString(engineFingerprint()));
}

// ---- names -------------------------------------------------------------------------------------------------------

TEST(InstructionSet, hasANameAndLanes)
{
  EXPECT_EQ("scalar", toString(InstructionSet::SCALAR));
  EXPECT_EQ("avx2", toString(InstructionSet::AVX2));
  EXPECT_EQ("avx512", toString(InstructionSet::AVX512));
  EXPECT_EQ(1, laneCount(InstructionSet::SCALAR));
  EXPECT_EQ(4, laneCount(InstructionSet::AVX2));
  EXPECT_EQ(8, laneCount(InstructionSet::AVX512));
}

TEST(InstructionSet, isParsedFromItsName)
{
  EXPECT_EQ(bestInstructionSet(), parseInstructionSet("auto"));
  EXPECT_TRUE(isSupported(bestInstructionSet()));
  for (const InstructionSet instruction_set : supportedInstructionSets())
  {
    EXPECT_EQ(instruction_set, parseInstructionSet(toString(instruction_set)));
  }
}

TEST(InstructionSet, rejectsUnknownNamesAndWhatTheProcessorLacks)
{
  try
  {
    parseInstructionSet("mmx");
    FAIL() << "accepted mmx";
  }
  catch (const InvalidInput& error)
  {
    EXPECT_STREQ("instruction set \"mmx\" is unknown; it must be auto, scalar, avx2 or avx512", error.what());
  }
  for (const InstructionSet instruction_set : { InstructionSet::AVX2, InstructionSet::AVX512 })
  {
    if (!isSupported(instruction_set))
    {
      EXPECT_THROW(parseInstructionSet(toString(instruction_set)), InvalidInput);
      EXPECT_THROW(makeSimulation(SoftBodySettings(), { uniformRobot(SoftBodySettings(), 0.0) }, instruction_set),
                   InvalidInput);
    }
  }
}
