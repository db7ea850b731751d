#include "devo_evo/render/appearance.h"
#include "devo_evo/render/life_playback.h"
#include "devo_evo/render/scene.h"
#include "devo_evo/render/shown_robot.h"

#include "devo_evo/rigid_body/quadruped.h"

#include <gtest/gtest.h>

#include <cmath>

namespace devo_evo
{
namespace
{
/// Legs that are drawn in over life, and bound.
DevelopmentalProgram shrinking()
{
  DevelopmentalProgram program;
  program.morphology_initial.assign(4, 1.0);
  program.morphology_final.assign(4, 0.2);
  program.control_initial = { 1.0, 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, -1.0 };
  program.control_final = program.control_initial;
  return program;
}

RigidBodySettings shortLife()
{
  RigidBodySettings settings;
  settings.lifetime = 1.0;
  settings.slope = 5.0;
  return settings;
}

/// Largest distance of a surface's corners from a place [m].
double reach(const Surface& surface, const Eigen::Vector3d& place)
{
  double farthest = 0.0;
  for (const Eigen::Vector3d& corner : surface.corners)
  {
    farthest = std::max(farthest, (corner - place).norm());
  }
  return farthest;
}

TEST(LivingQuadruped, EndsAsTheEvaluationDoes)
{
  const BodySettings body(shortLife());
  LifePlayback playback(body, shrinking());
  EXPECT_EQ(playback.time(), 0.0) << "life begins at birth";
  for (double time = 0.0; time < 0.9; time += 0.04)  // looked at on the way
  {
    ASSERT_TRUE(playback.advanceTo(time));
    playback.frame();
  }
  playback.finish();
  const Evaluation expected = makeBody(body)->evaluate({ shrinking() }, InstructionSet::SCALAR).front();
  EXPECT_EQ(playback.evaluation().state_hash, expected.state_hash);
  EXPECT_EQ(playback.evaluation().fitness, expected.fitness);
  EXPECT_FALSE(playback.diverged());
}

TEST(LivingQuadruped, RefusesRobotsOfAnotherBody)
{
  DevelopmentalProgram program = shrinking();
  program.morphology_initial.assign(48, 0.0);
  EXPECT_THROW(LifePlayback(BodySettings(shortLife()), program), InvalidInput);
}

TEST(LivingQuadruped, FramesTellLengthsDevelopmentAndPhases)
{
  LifePlayback playback(BodySettings(shortLife()), shrinking());
  playback.advanceTo(0.5);
  const RobotFrame frame = playback.frame();
  ASSERT_EQ(frame.parts.size(), 5u);
  EXPECT_EQ(frame.parts[0].position, frame.center_of_mass);
  const double phases[] = { 0.0, 0.25, 0.5, -0.25 };  // sine, cosine, and their opposites
  for (size_t leg = 1; leg <= 4; ++leg)
  {
    const ShownPart& part = frame.parts[leg];
    EXPECT_NEAR(part.resting_length, 0.04 + 0.3 * 0.6, 0.001);  // half-way from 1 to 0.2
    EXPECT_NEAR(part.remaining_development, -0.3 * 0.4, 0.001);
    EXPECT_NEAR(part.present_length, part.resting_length, 0.03) << "the actuator lags behind";
    EXPECT_NEAR(part.phase, phases[leg - 1], 1e-9);
  }
}

TEST(QuadrupedAppearance, HasPartsOfTheRightSizeInTheRightPlace)
{
  const BodySettings body(shortLife());
  const auto appearance = makeAppearance(body);
  LifePlayback playback(body, shrinking());
  playback.advanceTo(0.2);
  const RobotFrame frame = playback.frame();
  const std::vector<Surface> surfaces = appearance->surfaces(frame, Colouring::RESTING_LENGTH);
  ASSERT_EQ(surfaces.size(), 5u);
  for (const Eigen::Vector3d& corner : surfaces[0].corners)
  {
    EXPECT_NEAR((corner - frame.center_of_mass).norm(), 0.25, 1e-9);
  }
  for (size_t leg = 1; leg <= 4; ++leg)
  {
    // A rod of 0.34 m with its rounded ends; its foot is as far from the abdomen's surface as the leg protrudes.
    EXPECT_NEAR(reach(surfaces[leg], frame.parts[leg].position), 0.17, 1e-9);
    EXPECT_NEAR(reach(surfaces[leg], frame.center_of_mass), 0.25 + frame.parts[leg].present_length, 0.06);
    EXPECT_FALSE(surfaces[leg].flat);
  }
  EXPECT_TRUE(appearance->edges(frame).empty());
}

TEST(QuadrupedAppearance, LegsAreRedWhenOutAndBlueWhenDrawnIn)
{
  const auto appearance = makeAppearance(BodySettings(shortLife()));
  RobotFrame frame;
  frame.parts.resize(3);
  frame.parts[1].resting_length = frame.parts[1].present_length = 0.34;
  frame.parts[2].resting_length = 0.04;
  frame.parts[2].present_length = 0.34;
  frame.parts[1].remaining_development = -0.3;
  const Colour out = appearance->colourOf(frame, 1, Colouring::RESTING_LENGTH);
  EXPECT_NEAR(out.red, 1.0, 1e-6);
  EXPECT_NEAR(out.blue, 0.0, 1e-6);
  EXPECT_NEAR(appearance->colourOf(frame, 2, Colouring::RESTING_LENGTH).blue, 1.0, 1e-6);
  EXPECT_NEAR(appearance->colourOf(frame, 2, Colouring::PRESENT_LENGTH).red, 1.0, 1e-6);
  EXPECT_NEAR(appearance->colourOf(frame, 1, Colouring::REMAINING_DEVELOPMENT).blue, 1.0, 1e-6) << "it will shrink";
}

TEST(QuadrupedAppearance, FloorAndLightAreWhereTheSimulationHasThem)
{
  const RigidBodySettings settings = shortLife();
  const Surroundings surroundings = makeAppearance(BodySettings(settings))->surroundings();
  const QuadrupedSimulation simulation(settings, QuadrupedProgram());
  EXPECT_NEAR((surroundings.floorToWorld() * Eigen::Vector3d::UnitZ() - simulation.floorNormal()).norm(), 0.0, 1e-12);
  ASSERT_TRUE(surroundings.light);
  EXPECT_NEAR((*surroundings.light - simulation.light()).norm(), 0.0, 1e-9);
  EXPECT_EQ(surroundings.body_length, 0.5);
  EXPECT_LT((surroundings.floorToWorld() * Eigen::Vector3d::UnitY()).z(), 0.0) << "down towards +y";
}

TEST(QuadrupedAppearance, SoftBodiesHaveALevelFloorAndNoLight)
{
  const Surroundings surroundings = makeAppearance(BodySettings())->surroundings();
  EXPECT_EQ(surroundings.slope, 0.0);
  EXPECT_FALSE(surroundings.light);
  const Eigen::Vector3d place(1.0, 2.0, 3.0);
  EXPECT_EQ(surroundings.onFloor(place), place);
}

TEST(QuadrupedSurvey, MeasuresAlongTheFloor)
{
  ShownRobot robot;
  robot.body = BodySettings(shortLife());
  robot.program = shrinking();
  const LifeSurvey life = surveyLife(robot);
  const Surroundings surroundings = makeAppearance(robot.body)->surroundings();
  EXPECT_GT(life.birthplace.z(), 0.3) << "above the floor, on long legs";
  EXPECT_NEAR(life.birthplace.y(), 0.0, 0.01);
  const FloorPlan plan = floorPlan(life, surroundings);
  EXPECT_EQ(plan.body_length, 0.5);
}

TEST(Caption, HasTheFitnessOfTheBodyInItsUnit)
{
  ShownRobot robot;
  robot.name = "1/7";
  robot.body = BodySettings(RigidBodySettings());
  Evaluation evaluation;
  evaluation.valid = true;
  evaluation.fitness = 0.003801;
  EXPECT_EQ(captionText(robot, evaluation, 3.2), "1/7\nfitness 0.003801 1/m^2, 3.20 s");
}
}  // namespace
}  // namespace devo_evo
