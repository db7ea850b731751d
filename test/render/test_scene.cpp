#include "devo_evo/render/scene.h"

#include <gtest/gtest.h>

namespace devo_evo
{
namespace
{
TEST(MotionTrace, VelocityIsThatOfTheLastCycle)
{
  MotionTrace trace;
  EXPECT_EQ(trace.velocity(), Eigen::Vector3d::Zero());
  trace.add(0.0, Eigen::Vector3d::Zero());
  EXPECT_EQ(trace.velocity(), Eigen::Vector3d::Zero());
  for (int i = 1; i <= 100; ++i)  // 1 m/s along y until 0.5 s, then 2 m/s along x
  {
    const double time = 0.01 * i;
    trace.add(time, { 2.0 * std::max(0.0, time - 0.5), std::min(time, 0.5), 0.0 });
    if (i == 40)
    {
      EXPECT_LT((trace.velocity() - Eigen::Vector3d(0, 1, 0)).norm(), 1e-9);
    }
  }
  EXPECT_LT((trace.velocity() - Eigen::Vector3d(2, 0, 0)).norm(), 1e-9);
}

TEST(MotionTrace, PathGoesFromBirthToThePresentPlace)
{
  MotionTrace trace;
  EXPECT_TRUE(trace.path().empty());
  for (int i = 0; i <= 1000; ++i)
  {
    trace.add(0.01 * i, { 0.0, 0.01 * i, 0.0 });
  }
  const std::vector<Eigen::Vector3d> path = trace.path();
  EXPECT_EQ(path.front().y(), 0.0);
  EXPECT_EQ(path.back().y(), 10.0);
  EXPECT_NEAR(static_cast<double>(path.size()), 10.0 / MotionTrace::PATH_SPACING, 35.0);
}

LifeSurvey wayTo(double x, double y)
{
  LifeSurvey life;
  life.birthplace = { 0.02, 0.02, 0.015 };
  life.extent.extend(Eigen::Vector2d(0.02, 0.02));
  life.extent.extend(Eigen::Vector2d(x, y));
  return life;
}

TEST(FloorPlan, LinesAreABodyLengthApartCountedFromTheBirthplace)
{
  const FloorPlan plan =
      floorPlan(wayTo(0.02, 0.50), makeAppearance(BodySettings())->surroundings());  // 12 body lengths of 4 cm
  EXPECT_EQ(plan.body_length, 0.04);
  EXPECT_NEAR(plan.area.min().y(), 0.02 - 3 * 0.04, 1e-12);
  EXPECT_NEAR(plan.area.max().y(), 0.02 + 15 * 0.04, 1e-12);
  EXPECT_EQ(plan.lines.size(), 7u + 19u);  // along: -3 to 3; across: -3 to 15
  ASSERT_EQ(plan.labels.size(), 4u);
  for (size_t i = 0; i < plan.labels.size(); ++i)
  {
    EXPECT_EQ(plan.labels[i].second, std::to_string(5 * i));
    EXPECT_NEAR(plan.labels[i].first.y(), 0.02 + static_cast<double>(5 * i) * 0.04, 1e-12);
    EXPECT_NEAR(plan.marked_lines[i][0].y(), plan.labels[i].first.y(), 1e-12);
  }
}

TEST(FloorPlan, ReachesWhereverTheRobotGoes)
{
  const FloorPlan plan = floorPlan(wayTo(-0.5, -0.9), makeAppearance(BodySettings())->surroundings());
  EXPECT_LT(plan.area.min().x(), -0.5);
  EXPECT_LT(plan.area.min().y(), -0.9);
  EXPECT_EQ(plan.labels.front().second, "-25");
}

TEST(FloorPlan, IsBoundedHoweverFarARobotIsThrown)
{
  const FloorPlan plan = floorPlan(wayTo(1e200, -1e200), makeAppearance(BodySettings())->surroundings());
  EXPECT_LT(plan.lines.size(), 2200u);
}

TEST(FloorPlan, OfALifeThatDivergedAtOnceIsAroundTheBirthplace)
{
  LifeSurvey life;
  const FloorPlan plan = floorPlan(life, makeAppearance(BodySettings())->surroundings());
  EXPECT_EQ(plan.lines.size(), 14u);
}
}  // namespace
}  // namespace devo_evo
