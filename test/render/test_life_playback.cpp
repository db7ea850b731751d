#include "devo_evo/render/life_playback.h"

#include "soft_body/robots.h"

#include <gtest/gtest.h>

namespace devo_evo
{
namespace
{
SoftBodySettings shortLife()
{
  SoftBodySettings settings;
  settings.lifetime = 1.0;
  return settings;
}

TEST(LifePlayback, EndsAsTheEvaluationDoes)
{
  const SoftBodySettings settings = shortLife();
  const std::vector<DevelopmentalProgram> robots = scrambledRobots(settings, 3);
  const std::vector<Evaluation> evaluations = evaluate(settings, robots);
  for (size_t robot = 0; robot < robots.size(); ++robot)
  {
    LifePlayback playback(BodySettings(settings), robots[robot]);
    for (double time = 0.0; time < 0.9; time += 0.04)  // looked at on the way
    {
      ASSERT_TRUE(playback.advanceTo(time));
      playback.frame();
    }
    playback.finish();
    EXPECT_TRUE(playback.finished());
    EXPECT_EQ(playback.evaluation().state_hash, evaluations[robot].state_hash);
    EXPECT_EQ(playback.evaluation().fitness, evaluations[robot].fitness);
  }
}

TEST(LifePlayback, StopsAtTheFirstStepAfterATime)
{
  const SoftBodySettings settings = shortLife();
  LifePlayback playback(BodySettings(settings), scrambledRobot(settings, 1));
  EXPECT_LT(playback.time(), -0.49);
  ASSERT_TRUE(playback.advanceTo(0.3));
  EXPECT_GT(playback.time(), 0.3);
  EXPECT_LE(playback.time(), 0.3 + settings.timeStep());
  const double time = playback.time();
  ASSERT_TRUE(playback.advanceTo(0.1));  // that was before
  EXPECT_EQ(playback.time(), time);
  EXPECT_FALSE(playback.advanceTo(1.5));  // that is after its end
  EXPECT_NEAR(playback.time(), 1.0, settings.timeStep());
}

TEST(LifePlayback, AFrameIsTheStateOfTheSimulationAtThatTime)
{
  const SoftBodySettings settings = shortLife();
  const DevelopmentalProgram program = scrambledRobot(settings, 2);
  LifePlayback playback(BodySettings(settings), program);
  playback.advanceTo(0.4);
  const auto simulation = makeSimulation(settings, { program });
  while (simulation->time() <= SETTLING_TIME + 0.4)
  {
    simulation->step();
  }
  const RobotFrame frame = playback.frame();
  ASSERT_EQ(frame.parts.size(), 48u);
  EXPECT_EQ(frame.time_since_birth, simulation->time() - SETTLING_TIME);
  EXPECT_EQ(frame.center_of_mass, simulation->centerOfMass(0));
  EXPECT_TRUE(frame.finite());
  for (int voxel = 0; voxel < 48; ++voxel)
  {
    const ShownPart& shown = frame.parts[static_cast<size_t>(voxel)];
    const VoxelState state = simulation->voxel(0, voxel);
    EXPECT_EQ(shown.position, state.position);
    EXPECT_EQ(shown.orientation.coeffs(), state.orientation.coeffs());
    EXPECT_EQ(shown.present_length, state.scale);
    EXPECT_EQ(shown.resting_length, simulation->restingLength(0, voxel));
  }
}

TEST(LifePlayback, LengthAndPhaseDevelopLinearly)
{
  const SoftBodySettings settings = shortLife();
  DevelopmentalProgram program = uniformRobot(settings, 0.0, 0.1);
  program.morphology_final.assign(48, 0.4);  // from 1 cm to 1.3 cm
  program.control_final.assign(48, 0.2);
  LifePlayback playback(BodySettings(settings), program);
  playback.advanceTo(0.25);
  const ShownPart voxel = playback.frame().parts[17];
  constexpr double LAST_STEP = 1e-4;  // resting lengths are those of the last step
  EXPECT_NEAR(voxel.resting_length, 0.01075, LAST_STEP * 0.003 * 10);
  EXPECT_NEAR(voxel.remaining_development, 0.00225, LAST_STEP * 0.003 * 10);
  EXPECT_NEAR(voxel.phase, 0.125, 1e-3);
}

TEST(LifePlayback, ADivergedLifeEndsThere)
{
  SoftBodySettings settings = shortLife();
  settings.bond_damping = 10.0;
  LifePlayback playback(BodySettings(settings), scrambledRobot(settings, 1));
  EXPECT_FALSE(playback.advanceTo(0.9));
  EXPECT_TRUE(playback.diverged());
  EXPECT_TRUE(playback.finished());
  EXPECT_FALSE(playback.evaluation().valid);
}

TEST(LifePlayback, CanBeAbandoned)
{
  const SoftBodySettings settings = shortLife();
  LifePlayback playback(BodySettings(settings), scrambledRobot(settings, 1));
  const std::atomic<bool> stop{ true };
  EXPECT_THROW(playback.advanceTo(0.5, &stop), EvaluationAbandoned);
}
}  // namespace
}  // namespace devo_evo
