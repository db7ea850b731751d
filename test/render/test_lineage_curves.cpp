#include "devo_evo/render/lineage_curves.h"

#include "devo_evo/bodies/bodies.h"

#include <gtest/gtest.h>

#include <cmath>

namespace devo_evo
{
namespace
{
ArchivedIndividual ancestor(int64_t generation, std::optional<double> fitness)
{
  ArchivedIndividual ancestor;
  ancestor.individual.generation = generation;
  ancestor.individual.evaluation = Evaluation();
  ancestor.individual.evaluation->valid = fitness.has_value();
  ancestor.individual.evaluation->fitness = fitness.value_or(NAN);
  ancestor.morphology_window = 0.25;
  ancestor.control_window = 0.75;
  return ancestor;
}

LineageCurves softCurves()
{
  return lineageCurves(*makeSoftBody(SoftBodySettings()));
}

std::vector<std::string> textsOf(const std::vector<AxisTick>& ticks)
{
  std::vector<std::string> texts;
  for (const AxisTick& tick : ticks)
  {
    texts.push_back(tick.text);
  }
  return texts;
}

TEST(LineageCurves, AreFitnessAndTheTwoWindows)
{
  const LineageCurves curves = softCurves();
  const ArchivedIndividual one = ancestor(3, 1.5);
  EXPECT_EQ(curves[0].value(one), 1.5);
  EXPECT_EQ(curves[1].value(one), 0.25);
  EXPECT_EQ(curves[2].value(one), 0.75);
  EXPECT_TRUE(std::isnan(curves[0].value(ancestor(3, std::nullopt)))) << "it diverges";
  EXPECT_TRUE(std::isnan(curves[0].value(ArchivedIndividual()))) << "it is not evaluated";
}

TEST(LineageCurves, FitnessIsInTheUnitOfTheBody)
{
  EXPECT_EQ(softCurves()[0].title, "fitness [body lengths]");
  EXPECT_EQ(lineageCurves(*makeRigidBody(RigidBodySettings()))[0].title, "fitness [1/m^2]");
}

TEST(LineageCurves, AxesShowAllValuesAndZero)
{
  const std::vector<ArchivedIndividual> lineage = { ancestor(3, -0.5), ancestor(9, std::nullopt), ancestor(20, 4.0) };
  const AxisRange values = rangeOf(softCurves()[0], lineage);
  EXPECT_EQ(values.low, -0.5);
  EXPECT_GT(values.high, 4.0);
  EXPECT_EQ(rangeOf(softCurves()[1], lineage).low, 0.0);
  EXPECT_LT(rangeOf(softCurves()[0], { ancestor(3, 0.0025) }).high, 0.003) << "light is a small number";
  const AxisRange of_nobody = rangeOf(softCurves()[0], { ancestor(3, std::nullopt) });
  EXPECT_LT(of_nobody.low, of_nobody.high) << "an axis is never empty";
  const AxisRange generations = generationsOf(lineage);
  EXPECT_EQ(generations.low, 3.0);
  EXPECT_EQ(generations.high, 20.0);
  EXPECT_GT(generationsOf({ ancestor(7, 1.0) }).high, 7.0) << "an axis is never empty";
}

TEST(LineageCurves, TicksAreRoundNumbersWithinTheRange)
{
  EXPECT_EQ(textsOf(roundTicks({ 0.0, 1.2 }, 3)), (std::vector<std::string>{ "0.0", "0.5", "1.0" }));
  EXPECT_EQ(textsOf(roundTicks({ -3.0, 21.0 }, 4)), (std::vector<std::string>{ "0", "5", "10", "15", "20" }));
  EXPECT_EQ(textsOf(roundTicks({ 63.0, 119.0 }, 4)), (std::vector<std::string>{ "70", "80", "90", "100", "110" }));
  EXPECT_EQ(textsOf(roundTicks({ 0.0, 0.0019 }, 3)),
            (std::vector<std::string>{ "0.0000", "0.0005", "0.0010", "0.0015" }));
}
}  // namespace
}  // namespace devo_evo
