#include "study/frozen.h"

#include <gtest/gtest.h>

using namespace devo_evo;

namespace
{
const DevelopmentalProgram ROBOT = { { 0.0, -1.0 }, { 1.0, 0.5 }, { 0.25, 0.0 }, { -0.25, 0.125 } };
}  // namespace

TEST(FrozenAtBirth, keepsTheInitialValuesForLife)
{
  EXPECT_EQ(frozen(ROBOT, Moment::BIRTH, Scope::BOTH),
            (DevelopmentalProgram{ { 0.0, -1.0 }, { 0.0, -1.0 }, { 0.25, 0.0 }, { 0.25, 0.0 } }));
}

TEST(FrozenAtMidlife, hasTheMeanOfBothEnds)
{
  EXPECT_EQ(frozen(ROBOT, Moment::MIDLIFE, Scope::BOTH),
            (DevelopmentalProgram{ { 0.5, -0.25 }, { 0.5, -0.25 }, { 0.0, 0.0625 }, { 0.0, 0.0625 } }));
}

TEST(FrozenAtDeath, hasTheFinalValuesFromBirth)
{
  EXPECT_EQ(frozen(ROBOT, Moment::DEATH, Scope::BOTH),
            (DevelopmentalProgram{ { 1.0, 0.5 }, { 1.0, 0.5 }, { -0.25, 0.125 }, { -0.25, 0.125 } }));
}

TEST(FrozenInPart, leavesTheOtherToDevelop)
{
  EXPECT_EQ(frozen(ROBOT, Moment::BIRTH, Scope::BODY),
            (DevelopmentalProgram{ { 0.0, -1.0 }, { 0.0, -1.0 }, { 0.25, 0.0 }, { -0.25, 0.125 } }));
  EXPECT_EQ(frozen(ROBOT, Moment::DEATH, Scope::CONTROL),
            (DevelopmentalProgram{ { 0.0, -1.0 }, { 1.0, 0.5 }, { -0.25, 0.125 }, { -0.25, 0.125 } }));
}
