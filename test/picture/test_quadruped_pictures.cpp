#include "devo_evo/picture/life_scene.h"
#include "devo_evo/picture/pictures.h"
#include "devo_evo/picture/scene_painter.h"
#include "devo_evo/render/shown_robot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace devo_evo
{
namespace
{
ShownRobot quadruped(const std::string& name, double lifetime)
{
  RigidBodySettings world;
  world.lifetime = lifetime;
  return readRobotFile(PROJECT_DIR "/config/quadrupeds.jsonl", name, BodySettings(world));
}

/// Pixels of a hue in a picture: much more of it than of the others.
int countPixels(const Image& image, bool (*wanted)(int red, int green, int blue))
{
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
  {
    for (int x = 0; x < image.width(); ++x)
    {
      const auto [red, green, blue] = image.rgb(x, y);
      count += wanted(red, green, blue) ? 1 : 0;
    }
  }
  return count;
}

bool isRed(int red, int green, int blue)
{
  return red > green + 60 && red > blue + 60;
}

bool isBlue(int red, int green, int blue)
{
  return blue > red + 60 && blue > green + 60;
}

bool isYellow(int red, int green, int blue)
{
  return red > blue + 90 && green > blue + 50 && red - green < 80;
}

Image painted(const LifeScene& life)
{
  return ScenePainter(640, 360).paint(life.scene(), life.camera());
}

TEST(QuadrupedPicture, ShowsLongLegsInRedAndDrawnInOnesInBlue)
{
  const LifeScene walker(quadruped("walker", 1.0), ViewOptions());
  EXPECT_GT(countPixels(painted(walker), isRed), 300);
  EXPECT_EQ(countPixels(painted(walker), isBlue), 0);
  const LifeScene roller(quadruped("roller", 1.0), ViewOptions());
  EXPECT_GT(countPixels(painted(roller), isBlue), 20) << "they protrude a little";
  EXPECT_EQ(countPixels(painted(roller), isRed), 0);
}

TEST(QuadrupedPicture, ShowsTheAbdomenAsADiscOfItsSize)
{
  const LifeScene life(quadruped("roller", 1.0), ViewOptions());
  Scene scene = life.scene();
  ASSERT_EQ(scene.bodies.size(), 5u);
  scene.bodies.resize(1);
  for (Eigen::Vector3f& colour : scene.bodies.front().colours)
  {
    colour = Eigen::Vector3f(1.0f, 0.0f, 0.0f);
  }
  Camera camera = life.camera();
  camera.field_of_view = 0.0;
  camera.height = 1.0;
  const int area = countPixels(ScenePainter(640, 360).paint(scene, camera), isRed);
  const double radius = 0.25 * 360;  // [pixels]
  EXPECT_NEAR(area, 3.14159 * radius * radius, 0.04 * area);
}

TEST(QuadrupedPicture, ShowsTheFloorDescendTowardsTheLight)
{
  const LifeScene life(quadruped("roller", 1.0), ViewOptions());
  Camera camera = life.camera();
  camera.azimuth = 0.0;  // +y is to the right
  camera.field_of_view = 0.0;
  const Eigen::Vector2d here = camera.toPicture(life.place(), 640, 360);
  const Eigen::Vector2d ahead = camera.toPicture(life.place() + Eigen::Vector3d::UnitY(), 640, 360);
  EXPECT_NEAR((ahead.y() - here.y()) / (ahead.x() - here.x()), std::tan(3.0 / 57.2958) * std::cos(camera.elevation),
              1e-3);
}

TEST(QuadrupedPicture, HasTheLightInViewFarAhead)
{
  const LifeScene life(quadruped("roller", 1.0), ViewOptions());
  EXPECT_GT(countPixels(painted(life), isYellow), 20);
  ASSERT_TRUE(life.readings().to_light);
  EXPECT_NEAR(*life.readings().to_light, std::hypot(30.0, 1.0 - 0.25), 0.01);
}

TEST(QuadrupedPicture, TellsTheWayDownTheSlopeInBodyLengths)
{
  LifeScene life(quadruped("roller", 3.0), ViewOptions());
  while (life.next())
  {
  }
  const double descent = life.evaluation().body_measures.front();
  EXPECT_GT(descent, 0.3);
  EXPECT_NEAR(life.readings().travelled, descent / 0.5, 1e-4);  // but for the first time step
}

TEST(QuadrupedStrip, HasPosesAboveAndTheLengthOfALegBelow)
{
  ShownRobot robot = quadruped("walker", 1.0);
  robot.program.morphology_final.assign(4, 0.0);
  const Image strip = stripOfLife(robot, 3, std::nullopt, 600, Colouring::PRESENT_LENGTH);
  std::vector<int> red(3, 0);
  for (int y = 26; y < 230; ++y)
  {
    for (int x = 0; x < 600; ++x)
    {
      const auto [r, g, b] = strip.rgb(x, y);
      red[static_cast<size_t>(x / 200)] += isRed(r, g, b) ? 1 : 0;
    }
  }
  EXPECT_GT(red[0], 100) << "legs are out at birth";
  EXPECT_LT(red[2], red[0] / 4) << "and drawn in at the end";
  EXPECT_THROW(stripOfLife(robot, 3, 5, 600, Colouring::PHASE), InvalidInput);
}
}  // namespace
}  // namespace devo_evo
