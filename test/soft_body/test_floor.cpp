// Voxels on the floor and in the air, against mechanics done by hand (docs/physics.md 4). With the default material,
// m = 1 kg and L = 0.01 m:
//
//   floor stiffness 2 E L = 100,000 N/m        its damping 0.8 * 2 sqrt(m E L) = 357.771 N s/m
//   weight m g = 9.81 N                        global drag 0.01 * 2 sqrt(m E L) = 4.472136 N s/m
#include "soft_body/expect_vector.h"
#include "soft_body/hand_made_body.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace devo_evo;
using Eigen::Vector3d;

namespace
{
constexpr double G = 9.81;
constexpr double REST_HEIGHT = 0.005 - 9.81e-5;  // half a voxel less what 9.81 N press into 100,000 N/m

SoftBodySettings dragless(int grid_x = 1, int grid_y = 1, int grid_z = 1)
{
  SoftBodySettings settings = weightlessSettings(grid_x, grid_y, grid_z);
  settings.gravity = G;
  return settings;
}
}  // namespace

// ---- up and down -------------------------------------------------------------------------------------------------

TEST(Floor, carriesAVoxelAtTheDepthWhereItsStiffnessBearsTheWeight)
{
  HandMadeBody voxel(dragless());
  for (int step = 0; step < 1000; ++step)
  {
    voxel.step();
  }
  expectNear({ 0.005, 0.005, REST_HEIGHT }, voxel.position(0), 1e-15);
  EXPECT_NEAR(0.0, voxel.velocity(0).z(), 1e-12);
  EXPECT_TRUE(voxel.staticFriction(0));
}

TEST(Floor, isFeltOnlyBelowTheLowerFace)
{
  HandMadeBody voxel(weightlessSettings(1, 1, 1));
  voxel.setPosition(0, { 0.0, 0.0, 0.005 });  // touches, penetration 0
  EXPECT_EQ(Vector3d::Zero(), voxel.loadsOfStep().forces[0]);
  EXPECT_FALSE(voxel.staticFriction(0));
  voxel.setPosition(0, { 0.0, 0.0, 0.0049 });  // 0.1 mm deep: 10 N
  expectNear({ 0.0, 0.0, 10.0 }, voxel.loadsOfStep().forces[0], 1e-9);
  EXPECT_TRUE(voxel.staticFriction(0));
}

TEST(Floor, followsTheSizeThatTheVoxelHasNow)
{
  HandMadeBody voxel(weightlessSettings(1, 1, 1));
  voxel.setPosition(0, { 0.0, 0.0, 0.008 });
  voxel.setScale(0, 0.0175);  // half of it is 8.75 mm: 0.75 mm deep, 75 N
  expectNear({ 0.0, 0.0, 75.0 }, voxel.loadsOfStep().forces[0], 1e-9);
}

TEST(Floor, dampsVerticalMotion)
{
  HandMadeBody voxel(weightlessSettings(1, 1, 1));
  voxel.setPosition(0, { 0.0, 0.0, 0.0049 });
  voxel.setVelocity(0, { 0.0, 0.0, -0.01 });  // 10 N + 357.771 N s/m * 0.01 m/s = 13.57771 N
  voxel.step();
  EXPECT_NEAR(13.577708763999663, (voxel.velocity(0).z() + 0.01) / voxel.model().dt, 1e-9);
}

TEST(Floor, mayPullWhereDampingExceedsStiffness)
{
  // Leaving fast while still inside, it is held back: 10 N - 357.771 N s/m * 0.1 m/s = -25.777 N. So does the
  // reference.
  HandMadeBody voxel(weightlessSettings(1, 1, 1));
  voxel.setPosition(0, { 0.0, 0.0, 0.0049 });
  voxel.setVelocity(0, { 0.0, 0.0, 0.1 });
  voxel.step();
  EXPECT_NEAR(-25.77708763999663, (voxel.velocity(0).z() - 0.1) / voxel.model().dt, 1e-9);
}

// ---- sliding -----------------------------------------------------------------------------------------------------

TEST(Friction, bringsASlidingVoxelToRestAfterTheTimeAndDistanceOfTheTextbook)
{
  // mu_d g = 4.905 m/s^2: from 1 m/s it takes v / (mu_d g) = 0.20387 s and v^2 / (2 mu_d g) = 0.10194 m. In steps:
  // v_n = 1 - n a dt, so 818 steps of sliding and one in which friction would turn it around, and stops it.
  HandMadeBody voxel(dragless());
  voxel.setPosition(0, { 0.0, 0.0, REST_HEIGHT });
  voxel.setVelocity(0, { 0.6, 0.8, 0.0 });
  const double loss = 0.5 * G * voxel.model().dt;
  int steps = 0;
  double distance = 0.0;
  for (; !voxel.staticFriction(0) && steps < 2000; ++steps)
  {
    EXPECT_NEAR(1.0 - steps * loss, voxel.velocity(0).norm(), 1e-9);
    voxel.step();
    distance += voxel.velocity(0).norm() * voxel.model().dt;
  }
  EXPECT_EQ(819, steps);
  EXPECT_NEAR(0.20387, steps * voxel.model().dt, 2.5e-4);
  EXPECT_NEAR(0.10194, distance, 1.3e-4);  // semi-implicit: v dt / 2 less than in continuous time
  EXPECT_NEAR(voxel.model().dt * (818 - loss * 818 * 819 / 2), distance, 1e-9);
  EXPECT_EQ(0.0, voxel.velocity(0).x());
  EXPECT_EQ(0.0, voxel.velocity(0).y());
  expectNear({ 0.6 * distance, 0.8 * distance, REST_HEIGHT }, voxel.position(0), 1e-9);
}

TEST(Friction, growsWithTheLoad)
{
  // 1 mm deep: N = 100 N; friction mu_d N = 50 N against the motion
  HandMadeBody voxel(weightlessSettings(1, 1, 1));
  voxel.setPosition(0, { 0.0, 0.0, 0.004 });
  voxel.setVelocity(0, { -0.3, 0.4, 0.0 });
  voxel.step();
  expectNear({ -0.3 + 0.6 * 50.0 * voxel.model().dt, 0.4 - 0.8 * 50.0 * voxel.model().dt, 100.0 * voxel.model().dt },
             voxel.velocity(0), 1e-12);
  EXPECT_FALSE(voxel.staticFriction(0));
}

TEST(Friction, stopsAVoxelThatItWouldTurnAround)
{
  // mu_d N dt = 50 N * 2.49117e-4 s = 0.012456 kg m/s
  const auto speed_after = [](double speed)
  {
    HandMadeBody voxel(weightlessSettings(1, 1, 1));
    voxel.setPosition(0, { 0.0, 0.0, 0.004 });
    voxel.setVelocity(0, { speed, 0.0, 0.0 });
    voxel.step();
    EXPECT_EQ(voxel.velocity(0).x() == 0.0, voxel.staticFriction(0));
    return voxel.velocity(0).x();
  };
  EXPECT_EQ(0.0, speed_after(0.01245));
  EXPECT_NEAR(0.01247 - 0.0124559, speed_after(0.01247), 1e-7);
}

// ---- holding -----------------------------------------------------------------------------------------------------

TEST(Friction, holdsAVoxelUntilThePullExceedsItsGrip)
{
  // Two voxels of 9.81 N on the floor, mu_s = 1, with a stretched bond between them: 50,000 N/m.
  const auto pull = [](double stretch)
  {
    HandMadeBody body(dragless(2, 1, 1));
    body.clock.first_step = true;
    body.setPosition(0, { 0.005, 0.005, REST_HEIGHT });
    body.setPosition(1, { 0.015 + stretch, 0.005, REST_HEIGHT });
    const Vector3d force = body.loadsOfStep().forces[0];
    EXPECT_EQ(force.x() == 0.0, body.staticFriction(0));
    return force.x();
  };
  EXPECT_EQ(0.0, pull(1e-4));               // 5 N: held
  EXPECT_EQ(0.0, pull(1.96e-4));            // 9.80 N: held
  EXPECT_NEAR(9.82, pull(1.964e-4), 1e-7);  // gives way, and slides freely in its first step
  EXPECT_NEAR(-10.0, pull(-2e-4), 1e-7);
}

TEST(Friction, keepsAPulledPairInPlace)
{
  HandMadeBody body(dragless(2, 1, 1));
  body.setPosition(0, { 0.005, 0.005, REST_HEIGHT });
  body.setPosition(1, { 0.0151, 0.005, REST_HEIGHT });
  body.clock.first_step = true;
  for (int step = 0; step < 1000; ++step)
  {
    body.step();
    body.clock.first_step = false;
    ASSERT_TRUE(body.staticFriction(0) && body.staticFriction(1));
  }
  EXPECT_EQ(0.005, body.position(0).x());
  EXPECT_EQ(0.0151, body.position(1).x());
}

TEST(Friction, isAbsentInTheAir)
{
  HandMadeBody voxel(dragless());
  voxel.setPosition(0, { 0.0, 0.0, 1.0 });
  voxel.setVelocity(0, { 0.1, 0.0, 0.0 });
  voxel.step();
  EXPECT_EQ(0.1, voxel.velocity(0).x());
  EXPECT_FALSE(voxel.staticFriction(0));
}

// ---- in the air --------------------------------------------------------------------------------------------------

TEST(FreeFall, approachesTheSpeedAtWhichDragBearsTheWeight)
{
  // v_n = -(g / c) (1 - (1 - c dt)^n) with c = 4.472136 / s; the final speed is 2.19358 m/s.
  SoftBodySettings settings = dragless();
  settings.global_damping = 0.01;
  HandMadeBody voxel(settings);
  voxel.setPosition(0, { 0.0, 0.0, 100.0 });
  const double c = 4.47213595499958;
  for (int step = 1; step <= 10000; ++step)
  {
    voxel.step();
    const double expected = -G / c * (1.0 - std::pow(1.0 - c * voxel.model().dt, step));
    ASSERT_NEAR(expected, voxel.velocity(0).z(), 1e-11) << "step " << step;
  }
  EXPECT_NEAR(-2.19358, voxel.velocity(0).z(), 1e-4);
}

TEST(FreeFall, withoutDragGainsGravityTimesTime)
{
  HandMadeBody voxel(dragless());
  voxel.setPosition(0, { 0.0, 0.0, 10.0 });
  for (int step = 0; step < 1000; ++step)
  {
    voxel.step();
  }
  const double dt = voxel.model().dt;
  EXPECT_NEAR(-G * 1000 * dt, voxel.velocity(0).z(), 1e-12);
  EXPECT_NEAR(10.0 - G * dt * dt * 1000 * 1001 / 2, voxel.position(0).z(), 1e-12);
}

TEST(Rotation, turnsByItsAngularVelocity)
{
  // One full turn about an oblique axis at 2 pi rad/s in 1 s; the step's q += dt / 2 (0, w) q, normalised, turns by
  // 2 atan(|w| dt / 2) instead of |w| dt.
  HandMadeBody voxel(weightlessSettings(1, 1, 1));
  voxel.setPosition(0, { 0.0, 0.0, 1.0 });
  const Vector3d axis = Vector3d(1.0, 2.0, -2.0) / 3.0;
  const double speed = 6.283185307179586;
  voxel.setVectorAt(0, ANGULAR_MOMENTUM, speed / voxel.model().inverse_inertia * axis);
  const int steps = 4014;  // 0.99996 s
  for (int step = 0; step < steps; ++step)
  {
    voxel.step();
  }
  const double half_angle = steps * std::atan(speed * voxel.model().dt / 2.0);
  EXPECT_NEAR(std::cos(half_angle), voxel.at(0, ORIENTATION), 1e-11);
  expectNear(std::sin(half_angle) * axis, voxel.vectorAt(0, ORIENTATION + 1), 1e-11);
}

TEST(Rotation, decaysByGlobalDamping)
{
  // Each step leaves 1 - 10 zeta_g 2 sqrt(I E L^3) dt / I = 1 - 10 * 0.01 * 2 * sqrt(1e-4 / 6 * 5) * dt / (1e-4 / 6)
  // = 1 - 109.5445 / s * dt = 0.972711.
  SoftBodySettings settings = weightlessSettings(1, 1, 1);
  settings.global_damping = 0.01;
  HandMadeBody voxel(settings);
  voxel.setPosition(0, { 0.0, 0.0, 1.0 });
  voxel.setVectorAt(0, ANGULAR_MOMENTUM, { 1e-4, 0.0, 0.0 });
  voxel.step();
  EXPECT_NEAR(1.0 - 109.54451150103322 * voxel.model().dt, voxel.at(0, ANGULAR_MOMENTUM) / 1e-4, 1e-12);
  EXPECT_NEAR(0.972711, voxel.at(0, ANGULAR_MOMENTUM) / 1e-4, 1e-6);
}
