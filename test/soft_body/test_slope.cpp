// A floor that slopes, uphill along +y (docs/physics.md 4.1): a slope of 3/4 has the sine 3/5 and the cosine 4/5.
#include "soft_body/expect_vector.h"
#include "soft_body/hand_made_body.h"
#include "soft_body/robots.h"

#include <gtest/gtest.h>

using namespace devo_evo;

namespace
{
SoftBodySettings sloping(double slope)
{
  SoftBodySettings settings = weightlessSettings(1, 1, 1);
  settings.gravity = 10.0;
  settings.slope = slope;
  return settings;
}

void run(HandMadeBody& voxel, int steps)
{
  for (int step = 0; step < steps; ++step)
  {
    voxel.step();
  }
}
}  // namespace

TEST(Slope, tiltsGravityAsSeenFromTheFloor)
{
  for (const double direction : { 1.0, -1.0 })
  {
    HandMadeBody voxel(sloping(0.75 * direction));
    voxel.setPosition(0, { 0.0, 0.0, 1.0 });
    expectNear({ 0.0, -6.0 * direction, -8.0 }, voxel.loadsOfStep().forces[0], 1e-9);
  }
}

TEST(Slope, holdsAVoxelAsLongAsItIsLessSteepThanStaticFriction)
{
  SoftBodySettings settings = sloping(0.75);
  settings.static_friction = 0.8;
  HandMadeBody held(settings);
  held.setPosition(0, { 0.0, 0.0, 0.005 - 8e-5 });  // where 8 N press it into the floor
  run(held, 2000);
  EXPECT_TRUE(held.staticFriction(0));
  EXPECT_EQ(0.0, held.velocity(0).y());

  settings.static_friction = 0.7;
  settings.dynamic_friction = 0.5;
  HandMadeBody sliding(settings);
  run(sliding, 2000);
  const double velocity = sliding.velocity(0).y();
  run(sliding, 100);
  EXPECT_FALSE(sliding.staticFriction(0));
  const double acceleration = (sliding.velocity(0).y() - velocity) / (100 * settings.timeStep());
  EXPECT_NEAR(-2.0, acceleration, 0.01);  // g (sin - 0.5 cos)
}

TEST(Slope, ofNothingChangesNoBitAndAnotherDoes)
{
  SoftBodySettings settings;
  settings.lifetime = 0.3;
  const DevelopmentalProgram robot = scrambledRobot(settings, 1);
  const Evaluation level = evaluate(settings, { robot }).front();
  settings.slope = -0.0;
  EXPECT_EQ(level.state_hash, evaluate(settings, { robot }).front().state_hash);
  settings.slope = 0.1;
  const Evaluation uphill = evaluate(settings, { robot }).front();
  EXPECT_NE(level.state_hash, uphill.state_hash);
  settings.slope = -0.1;
  EXPECT_GT(evaluate(settings, { robot }).front().fitness, uphill.fitness);
}
