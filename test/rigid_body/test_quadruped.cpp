#include "devo_evo/rigid_body/quadruped.h"

#include "devo_evo/soft_body/simulation.h"
#include "rigid_body/quadrupeds.h"

#include <gtest/gtest.h>
#include <ode/misc.h>

#include <cmath>
#include <thread>
#include <vector>

namespace devo_evo
{
namespace
{
constexpr double DEGREE = 3.14159265358979 / 180.0;

RigidBodySettings onFlatFloor()
{
  RigidBodySettings settings;
  settings.slope = 0.0;
  settings.lifetime = 2.0;
  return settings;
}

template <class Look>
void live(QuadrupedSimulation& simulation, Look look)
{
  while (!simulation.finished())
  {
    simulation.step();
    look();
  }
}

TEST(Light, FallsWithTheSquareOfTheDistance)
{
  EXPECT_DOUBLE_EQ(lightIntensity({ 0.0, 20.0, 1.0 }, { 0.0, 19.0, 1.0 }), 1.0);
  EXPECT_DOUBLE_EQ(lightIntensity({ 0.0, 20.0, 1.0 }, { 0.0, 18.0, 1.0 }), 0.25);
  EXPECT_DOUBLE_EQ(lightIntensity({ 3.0, 4.0, 0.0 }, { 0.0, 0.0, 0.0 }), 1.0 / 25.0);
}

TEST(Quadruped, FitnessOfAMotionlessRobotIsTheIntensityWhereItRests)
{
  // The abdomen rests on the floor, with its centre one radius above it and the light 30 m away and 1 m above it:
  // 1 / (30^2 + (1 - 0.25)^2). It sinks in by 1.4 kg * 9.81 m/s^2 / 10 kN/m = 1.4 mm.
  const QuadrupedEvaluation evaluation = evaluateQuadruped(onFlatFloor(), motionless(0.0));
  ASSERT_TRUE(evaluation.valid);
  EXPECT_NEAR(evaluation.fitness, 1.0 / (900.0 + 0.75 * 0.75), 1e-8);
  EXPECT_NEAR(evaluation.descent, 0.0, 1e-3);
  EXPECT_NEAR(evaluation.turns, 0.0, 1e-3);
  EXPECT_EQ(evaluation.leg_contact, 0.0);
  EXPECT_GT(evaluation.abdomen_contact, 0.99);
  ASSERT_TRUE(evaluation.first_abdomen_contact_s);
  EXPECT_LT(*evaluation.first_abdomen_contact_s, 0.02);
}

TEST(Quadruped, LongLegsCarryTheAbdomen)
{
  QuadrupedSimulation simulation(onFlatFloor(), motionless(1.0));
  live(simulation, [] {});
  const QuadrupedEvaluation evaluation = simulation.evaluation();
  // (0.25 + 0.04 + 0.3 - 0.025) m sin 45 degrees + 0.025 m = 0.4245 m, less what motors and floor give way.
  EXPECT_NEAR(simulation.abdomen().position.z(), 0.4245, 0.01);
  EXPECT_EQ(evaluation.abdomen_contact, 0.0);
  EXPECT_FALSE(evaluation.first_abdomen_contact_s);
  EXPECT_GT(evaluation.leg_contact, 0.99);
}

TEST(Quadruped, ASphereWithoutLegsRollsAsMechanicsSays)
{
  // A homogeneous sphere rolls down with 5/7 g sin(slope); its legs are flush with it and weigh next to nothing.
  RigidBodySettings settings;
  settings.lifetime = 3.0;
  settings.leg_residual = 0.0;
  settings.leg_mass = 1e-4;
  const QuadrupedEvaluation evaluation = evaluateQuadruped(settings, motionless(0.0));
  const double acceleration = 5.0 / 7.0 * 9.81 * std::sin(settings.slope * DEGREE);
  const double distance = 0.5 * acceleration * 3.0 * 3.0;
  EXPECT_NEAR(evaluation.descent, distance, 0.01 * distance);
  EXPECT_NEAR(evaluation.turns, distance / (2.0 * 180.0 * DEGREE * 0.25), 0.01 * evaluation.turns);
  EXPECT_NEAR(evaluation.sideways, 0.0, 1e-3);
  // Half a turn is half its circumference: 0.785 m, after sqrt(2 s / (5/7 g sin(slope))).
  ASSERT_TRUE(evaluation.first_roll_s);
  EXPECT_NEAR(*evaluation.first_roll_s, std::sqrt(2.0 * 180.0 * DEGREE * 0.25 / acceleration), 0.02);
}

TEST(Quadruped, HingesReachTheirLimitsAndStayWithinThem)
{
  RigidBodySettings settings = onFlatFloor();
  settings.gravity = 0.0;
  QuadrupedSimulation simulation(settings, withWeights(1.0, { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 }));
  double lowest = 0.0;
  double highest = 0.0;
  live(simulation,
       [&]
       {
         for (size_t leg = 0; leg < LEG_COUNT; ++leg)
         {
           lowest = std::min(lowest, simulation.hingeAngle(leg));
           highest = std::max(highest, simulation.hingeAngle(leg));
         }
       });
  EXPECT_NEAR(lowest, -45.0 * DEGREE, 2.0 * DEGREE);
  EXPECT_NEAR(highest, 45.0 * DEGREE, 2.0 * DEGREE);
}

TEST(Quadruped, PositiveHingeAnglesSwingFeetToTheFront)
{
  RigidBodySettings settings = onFlatFloor();
  settings.gravity = 0.0;
  settings.lifetime = 0.25;
  QuadrupedSimulation simulation(settings, withWeights(1.0, { 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 }));
  const auto forward = [&] { return simulation.leg(0).position.y() - simulation.abdomen().position.y(); };
  const double at_birth = forward();
  live(simulation, [] {});
  EXPECT_GT(simulation.hingeAngle(0), 10.0 * DEGREE);
  EXPECT_GT(forward(), at_birth + 0.01);
  EXPECT_NEAR(simulation.hingeAngle(1), 0.0, 3.0 * DEGREE);
}

TEST(Quadruped, LegsGrowFromInitialToFinalLength)
{
  QuadrupedProgram program = motionless(0.2);
  program.leg_length_final = { 0.9, 1.0, 0.2, 0.0 };
  QuadrupedSimulation simulation(onFlatFloor(), program);
  EXPECT_DOUBLE_EQ(simulation.legLength(0), 0.2);
  live(simulation,
       [&]
       {
         if (simulation.stepCount() == 400)
         {
           EXPECT_NEAR(simulation.legLength(0), 0.55, 0.05);  // half of the life, less the actuator's lag
           EXPECT_NEAR(simulation.legLength(3), 0.1, 0.05);
         }
       });
  for (size_t leg = 0; leg < LEG_COUNT; ++leg)
  {
    EXPECT_NEAR(simulation.legLength(leg), program.leg_length_final[leg], 0.05) << leg;
  }
}

TEST(Quadruped, EnergyDoesNotGrowWithoutMotors)
{
  RigidBodySettings settings;
  settings.lifetime = 4.0;
  settings.hinge_torque = 0.0;
  settings.actuator_force = 0.0;
  QuadrupedSimulation simulation(settings, motionless(0.7));
  double lowest = simulation.mechanicalEnergy();
  double growth = 0.0;
  const double at_birth = lowest;
  live(simulation,
       [&]
       {
         const double energy = simulation.mechanicalEnergy();
         growth = std::max(growth, energy - lowest);
         lowest = std::min(lowest, energy);
       });
  EXPECT_LT(lowest, at_birth - 1.0);  // it fell
  EXPECT_LT(growth, 0.05);            // [J]: what the springs of floor and stops give back, of 4 J
}

TEST(Quadruped, AWalkerWalksAndLongerLegsWalkFaster)
{
  const RigidBodySettings settings;
  const QuadrupedEvaluation still = evaluateQuadruped(settings, motionless(1.0));
  const QuadrupedEvaluation walking = evaluateQuadruped(settings, walker());
  const QuadrupedEvaluation shorter = evaluateQuadruped(settings, walker(0.5));
  EXPECT_NEAR(still.descent, 0.0, 0.02);
  EXPECT_GT(walking.descent, 0.25);
  EXPECT_GT(walking.descent, 1.2 * shorter.descent);
  EXPECT_GT(walking.fitness, still.fitness);
  EXPECT_LT(std::abs(walking.turns), 0.1);
  EXPECT_FALSE(walking.first_roll_s);
  EXPECT_LT(walking.abdomen_contact, 0.2);
}

TEST(Quadruped, ARollerRollsFurtherThanAWalkerWalks)
{
  const RigidBodySettings settings;
  const QuadrupedEvaluation rolling = evaluateQuadruped(settings, roller());
  EXPECT_GT(rolling.turns, 2.0);
  EXPECT_GT(rolling.abdomen_contact, 0.5);
  EXPECT_GT(rolling.fitness, 1.1 * evaluateQuadruped(settings, walker()).fitness);
}

TEST(Quadruped, LegsThatProtrudeEvenAtTheirShortestSlowRolling)
{
  const RigidBodySettings settings;
  RigidBodySettings smooth = settings;
  smooth.leg_residual = 0.0;
  const double passive = evaluateQuadruped(settings, motionless(0.0)).descent;
  EXPECT_LT(passive, 0.9 * evaluateQuadruped(smooth, motionless(0.0)).descent);
  EXPECT_GT(passive, 5.0) << "they do not stop it";
  EXPECT_GT(evaluateQuadruped(settings, roller()).descent, 1.05 * passive) << "motors help it";
  RigidBodySettings protruding = settings;
  protruding.leg_residual = 0.08;
  EXPECT_LT(evaluateQuadruped(protruding, roller()).turns, 0.5);
}

TEST(Quadruped, LegsThatAreOutALittleStopAPassiveRobotButNotAnActiveOne)
{
  const RigidBodySettings settings;
  EXPECT_LT(evaluateQuadruped(settings, motionless(0.02)).turns, 0.5);
  EXPECT_GT(evaluateQuadruped(settings, walker(0.02)).turns, 2.0);
  EXPECT_LT(evaluateQuadruped(settings, walker(0.2)).turns, 0.5) << "these are too long";
}

TEST(Quadruped, DrawingLegsInStartsARollLateInLife)
{
  RigidBodySettings settings;
  for (const double time_step : { settings.time_step, 0.5 * settings.time_step })
  {
    settings.time_step = time_step;
    const QuadrupedEvaluation late = evaluateQuadruped(settings, latecomer());
    ASSERT_TRUE(late.first_roll_s);
    EXPECT_GT(*late.first_roll_s, 8.0);
    EXPECT_GT(late.velocity.back(), 0.5) << "it is still rolling at the end";
    EXPECT_LT(std::abs(late.velocity[10]), 0.3) << "in the middle of its life it is on its legs";
  }
}

TEST(Quadruped, GaitsDoNotHingeOnTheTimeStep)
{
  const RigidBodySettings settings;
  RigidBodySettings halved = settings;
  halved.time_step = 0.5 * settings.time_step;
  const double walked = evaluateQuadruped(settings, walker()).descent;
  EXPECT_NEAR(evaluateQuadruped(halved, walker()).descent, walked, 0.2 * walked);
  for (const QuadrupedProgram& rolling : { roller(), motionless(0.0) })
  {
    const double rolled = evaluateQuadruped(settings, rolling).descent;
    EXPECT_NEAR(evaluateQuadruped(halved, rolling).descent, rolled, 0.02 * rolled);
  }
}

TEST(Quadruped, LivesAreTheSameInAnyThreadAndWhateverTheRandomNumbersOfOde)
{
  RigidBodySettings settings;
  settings.lifetime = 3.0;
  const QuadrupedEvaluation expected = evaluateQuadruped(settings, roller());
  ASSERT_TRUE(expected.valid);
  dRandSetSeed(12345);
  std::vector<QuadrupedEvaluation> evaluations(4);
  std::vector<std::thread> threads;
  for (QuadrupedEvaluation& evaluation : evaluations)
  {
    threads.emplace_back(
        [&]
        {
          evaluateQuadruped(settings, walker());
          evaluation = evaluateQuadruped(settings, roller());
        });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const QuadrupedEvaluation& evaluation : evaluations)
  {
    EXPECT_EQ(evaluation.state_hash, expected.state_hash);
    EXPECT_EQ(evaluation.fitness, expected.fitness);
  }
  EXPECT_NE(evaluateQuadruped(settings, walker()).state_hash, expected.state_hash);
}

TEST(Quadruped, IsGivenUpOutOfAllBounds)
{
  RigidBodySettings settings;
  settings.gravity = 100.0;
  settings.slope = 45.0;
  settings.friction = 0.0;
  settings.lifetime = 1000.0;
  settings.time_step = 0.05;
  const QuadrupedEvaluation evaluation = evaluateQuadruped(settings, motionless(0.0));
  EXPECT_FALSE(evaluation.valid);
  EXPECT_TRUE(evaluation.failed_step);
  EXPECT_TRUE(std::isnan(evaluation.fitness));
  EXPECT_EQ(evaluation.state_hash, 0u);
}

TEST(Quadruped, StopsWhenTold)
{
  const std::atomic<bool> stop{ true };
  EXPECT_THROW(evaluateQuadruped(RigidBodySettings(), walker(), &stop), EvaluationAbandoned);
}
}  // namespace
}  // namespace devo_evo
