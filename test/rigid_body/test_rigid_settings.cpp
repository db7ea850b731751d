#include "devo_evo/rigid_body/quadruped_program.h"
#include "devo_evo/rigid_body/settings.h"
#include "rigid_body/cycle_functions.h"
#include "rigid_body/quadrupeds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace devo_evo
{
namespace
{
std::string complaint(const std::function<void()>& action)
{
  try
  {
    action();
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
  return "";
}

TEST(RigidBodySettings, DefaultsAreValid)
{
  EXPECT_NO_THROW(RigidBodySettings().validate());
  EXPECT_EQ(RigidBodySettings().stepCount(), 4000);
}

TEST(RigidBodySettings, EveryFieldIsCheckedAndNamed)
{
  for (const auto& field : rigidBodyReals())
  {
    for (const double wrong : { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                                std::nextafter(field.maximum, 1e300), std::nextafter(field.minimum, -1e300) })
    {
      RigidBodySettings settings;
      settings.*field.value = wrong;
      const std::string text = complaint([&] { settings.validate(); });
      EXPECT_EQ(text.rfind(std::string(field.name) + " is ", 0), 0u) << field.name << ": " << text;
    }
  }
}

TEST(RigidBodySettings, LegsHaveToFitIntoTheAbdomen)
{
  RigidBodySettings settings;
  settings.leg_range = 0.36;  // 2 * 0.25 m cos 45 degrees = 0.354 m
  EXPECT_NE(complaint([&] { settings.validate(); }).find("drawn in by at most 0.3535"), std::string::npos);
}

TEST(RigidBodySettings, LegsAreAtLeastAsLongAsTheirRoundedEnds)
{
  RigidBodySettings settings;
  settings.leg_range = 0.0;
  EXPECT_NE(complaint([&] { settings.validate(); }).find("at least twice rigid_leg_radius, 0.05"), std::string::npos);
}

TEST(RigidBodySettings, StepsAreBounded)
{
  RigidBodySettings settings;
  settings.lifetime = 1000.0;
  settings.time_step = 1e-5;
  EXPECT_NE(complaint([&] { settings.validate(); }).find("steps"), std::string::npos);
}

TEST(QuadrupedProgram, ValuesAreCheckedAndNamed)
{
  QuadrupedProgram program = walker();
  EXPECT_EQ(complaint([&] { validate(program); }), "");
  program.leg_length_final[2] = -0.5;
  EXPECT_EQ(complaint([&] { validate(program); }), "leg_length_final[2] is -0.5; it must lie within 0 to 1");
  program = walker();
  program.weight_initial[7] = 1.5;
  EXPECT_EQ(complaint([&] { validate(program); }), "weight_initial[7] is 1.5; it must lie within -1 to 1");
  program.weight_initial[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(complaint([&] { validate(program); }).find("weight_initial[7] is nan"), std::string::npos);
}

TEST(CycleFunctions, AgreeWithTheSine)
{
  for (int i = -4000; i <= 4000; ++i)
  {
    const double cycles = i / 700.0;
    EXPECT_NEAR(sineOfCycles(cycles), std::sin(2.0 * std::acos(-1.0) * cycles), 1e-14);
    EXPECT_NEAR(cosineOfCycles(cycles), std::cos(2.0 * std::acos(-1.0) * cycles), 1e-14);
  }
  EXPECT_DOUBLE_EQ(sineOfCycles(0.25), 1.0);
  EXPECT_EQ(sineOfCycles(1e6), 0.0);
}
}  // namespace
}  // namespace devo_evo
