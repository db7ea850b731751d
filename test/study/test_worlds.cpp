#include "study/worlds.h"

#include <gtest/gtest.h>

using namespace devo_evo;

TEST(RobustnessWorlds, areTheOneThatRobotsEvolvedInAndOneForEachChange)
{
  StudySettings study;
  study.friction_factors = { 0.5 };
  study.gravity_factors = { 2 };
  study.slopes = { -0.1 };
  study.amplitude_factors = { 1.5 };
  const SoftBodySettings body;
  const std::vector<World> worlds = robustnessWorlds(body, study);
  ASSERT_EQ(worlds.size(), 5u);
  EXPECT_EQ(worlds[0].name, "as_evolved");
  EXPECT_FALSE(worlds[0].value);
  EXPECT_EQ(worlds[1].name, "friction*0.5");
  EXPECT_EQ(worlds[1].body.static_friction, 0.5);
  EXPECT_EQ(worlds[1].body.dynamic_friction, 0.25);
  EXPECT_EQ(worlds[2].name, "gravity*2");
  EXPECT_EQ(worlds[2].body.gravity, 19.62);
  EXPECT_EQ(worlds[3].name, "slope=-0.1");
  EXPECT_EQ(worlds[3].body.slope, -0.1);
  EXPECT_EQ(worlds[3].quantity, "slope");
  EXPECT_EQ(worlds[4].body.actuation_amplitude, 0.14 * 1.5);
  EXPECT_EQ(worlds[4].body.gravity, body.gravity);
}

TEST(RobustnessWorlds, thatCannotBeSimulatedAreRefused)
{
  StudySettings study;
  study.friction_factors = { 100 };
  SoftBodySettings body;
  body.static_friction = 2.0;
  EXPECT_THROW(robustnessWorlds(body, study), InvalidInput);
}
