#include "devo_evo/study/gait_map.h"

#include "archive/test_tools.h"
#include "devo_evo/soft_body/simulation.h"
#include "rigid_body/quadrupeds.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace devo_evo
{
namespace
{
using test::messageOf;

QuadrupedEvaluation lived(double turns, double abdomen_contact)
{
  QuadrupedEvaluation evaluation;
  evaluation.valid = true;
  evaluation.fitness = 0.0025;
  evaluation.turns = turns;
  evaluation.abdomen_contact = abdomen_contact;
  return evaluation;
}

/// A short life: what counts here is who is kept.
RigidBodySettings shortLife()
{
  RigidBodySettings world;
  world.lifetime = 3.0;
  world.slope = 6.0;
  world.leg_residual = 0.0;
  return world;
}

GaitSearch smallSearch()
{
  GaitSearch search;
  search.known = { walker(), roller() };
  search.random_robots = 1;
  search.climbing_steps = 2;
  return search;
}

class Counter : public GaitMapObserver
{
public:
  void cellDone(const GaitMapCell& /*cell*/) override { ++count_; }
  bool stopRequested() override { return false; }
  int count() const { return count_; }

private:
  int count_ = 0;
};

/// Gives up after the first world, or before.
class Quitter : public GaitMapObserver
{
public:
  explicit Quitter(bool at_once) : at_once_(at_once) {}
  void cellDone(const GaitMapCell& /*cell*/) override { throw std::runtime_error("enough"); }
  bool stopRequested() override { return at_once_; }

private:
  const bool at_once_;
};

TEST(GaitOf, TellsWalkersFromRollers)
{
  EXPECT_EQ(gaitOf(lived(1.2, 0.9)), Gait::ROLLING);
  EXPECT_EQ(gaitOf(lived(0.1, 0.0)), Gait::WALKING);
  EXPECT_EQ(gaitOf(lived(0.1, 0.9)), std::nullopt) << "it lies on its abdomen";
  EXPECT_EQ(gaitOf(lived(0.7, 0.1)), std::nullopt) << "it tumbles";
  EXPECT_EQ(gaitOf(lived(-2.0, 0.9)), std::nullopt) << "it rolls uphill";
  EXPECT_EQ(gaitOf(QuadrupedEvaluation()), std::nullopt);
}

TEST(GaitSearch, FindsBothGaitsNoWorseThanItBegan)
{
  const RigidBodySettings world = shortLife();
  const GaitMapCell cell = searchGaits(world, smallSearch());
  ASSERT_TRUE(cell.walking);
  ASSERT_TRUE(cell.rolling);
  EXPECT_EQ(gaitOf(cell.walking->evaluation), Gait::WALKING);
  EXPECT_EQ(gaitOf(cell.rolling->evaluation), Gait::ROLLING);
  EXPECT_GE(cell.walking->evaluation.fitness, evaluateQuadruped(world, walker()).fitness);
  EXPECT_GE(cell.rolling->evaluation.fitness, evaluateQuadruped(world, roller()).fitness);
  EXPECT_EQ(cell.evaluations, 2 + 2 * (2 + 1) + 4 * 2);
  EXPECT_EQ(cell.walking->program.leg_length_final, cell.walking->program.leg_length_initial) << "it does not develop";
  EXPECT_EQ(cell.rolling->program.weight_final, cell.rolling->program.weight_initial);
}

TEST(GaitSearch, LooksAtRobotsThatDrawTheirLegsInAndAtPassiveOnes)
{
  const RigidBodySettings world = shortLife();
  const GaitMapCell cell = searchGaits(world, smallSearch());
  for (size_t leg = 0; leg < LEG_COUNT; ++leg)
  {
    EXPECT_EQ(cell.drawing_in.program.leg_length_initial[leg], 0.5);
    EXPECT_EQ(cell.drawing_in.program.leg_length_final[leg], 0.0);
  }
  EXPECT_TRUE(cell.drawing_in.evaluation.valid);
  EXPECT_EQ(cell.passive.state_hash, evaluateQuadruped(world, motionless(0.0)).state_hash);
  EXPECT_EQ(cell.smooth.state_hash, cell.passive.state_hash) << "in a world without protrusion";
  RigidBodySettings protruding = world;
  protruding.leg_residual = 0.06;
  EXPECT_LT(searchGaits(protruding, smallSearch()).passive.descent, 0.5 * cell.smooth.descent);
}

/// A world in which all is as the paper says.
GaitMapCell likeThePaper()
{
  GaitMapCell cell;
  cell.walking = LivedQuadruped{ {}, lived(0.0, 0.0) };
  cell.walking->evaluation.descent = 0.6;
  cell.rolling = LivedQuadruped{ {}, lived(3.0, 0.9) };
  cell.rolling->evaluation.fitness = 0.003;
  cell.rolling->evaluation.descent = 7.0;
  cell.passive = lived(0.1, 1.0);
  cell.passive.descent = 0.2;
  cell.smooth = lived(5.0, 1.0);
  cell.smooth.descent = 12.0;
  cell.drawing_in.evaluation = lived(0.6, 0.3);
  cell.drawing_in.evaluation.first_roll_s = 9.0;
  cell.drawing_in.evaluation.velocity = { 0.0, 0.5 };
  return cell;
}

TEST(PaperObservations, HoldWhereAllIsAsThePaperSays)
{
  EXPECT_TRUE(observe(likeThePaper()).all());
}

TEST(PaperObservations, FailOneByOne)
{
  GaitMapCell cell = likeThePaper();
  cell.walking->evaluation.descent = 0.4;
  EXPECT_FALSE(observe(cell).walks) << "less than a body length";
  EXPECT_TRUE(observe(cell).rolls_better);

  cell = likeThePaper();
  cell.rolling->evaluation.fitness = 1.05 * cell.walking->evaluation.fitness;
  EXPECT_FALSE(observe(cell).rolls_better);
  EXPECT_TRUE(observe(cell).protruding_hinders);

  cell = likeThePaper();
  cell.passive.descent = 11.5;
  EXPECT_FALSE(observe(cell).protruding_hinders) << "it rolls as if nothing protruded";
  cell.passive.descent = 8.0;
  EXPECT_FALSE(observe(cell).protruding_hinders) << "controllers are of no use";

  cell = likeThePaper();
  cell.drawing_in.evaluation.first_roll_s.reset();
  EXPECT_FALSE(observe(cell).drawing_in_rolls);
  cell.drawing_in.evaluation.first_roll_s = 3.0;
  EXPECT_FALSE(observe(cell).drawing_in_rolls) << "it rolls early";
  cell.drawing_in.evaluation.first_roll_s = 9.0;
  cell.drawing_in.evaluation.velocity.back() = 0.01;
  EXPECT_FALSE(observe(cell).drawing_in_rolls) << "it does not go on rolling";
  EXPECT_FALSE(observe(cell).all());
}

TEST(PaperObservations, FailWhereAGaitWasNotFound)
{
  GaitMapCell cell = likeThePaper();
  cell.rolling.reset();
  EXPECT_TRUE(observe(cell).walks);
  EXPECT_FALSE(observe(cell).rolls_better);
  EXPECT_FALSE(observe(cell).protruding_hinders);
  cell.walking.reset();
  EXPECT_FALSE(observe(cell).walks);
  EXPECT_FALSE(observe(GaitMapCell()).all());
}

TEST(GaitSearch, SaysThatThereIsNoGaitWhereThereIsNone)
{
  RigidBodySettings world = shortLife();
  world.slope = 0.0;
  world.leg_residual = 0.0;
  GaitSearch search;
  search.known = { motionless(0.0) };
  search.random_robots = search.climbing_steps = 0;
  const GaitMapCell cell = searchGaits(world, search);
  EXPECT_FALSE(cell.rolling);
  EXPECT_FALSE(cell.walking);
}

TEST(GaitMap, HasEveryWorldInItsPlaceWhateverTheThreads)
{
  const std::vector<double> slopes = { 0.0, 6.0 };
  const std::vector<double> residuals = { 0.0, 0.04 };
  Counter counter;
  const auto one = mapGaits(shortLife(), slopes, residuals, smallSearch(), 1, counter);
  const auto three = mapGaits(shortLife(), slopes, residuals, smallSearch(), 3, counter);
  EXPECT_EQ(counter.count(), 8);
  ASSERT_EQ(one.size(), 4u);
  for (size_t i = 0; i < one.size(); ++i)
  {
    EXPECT_EQ(one[i].world.slope, slopes[i / 2]);
    EXPECT_EQ(one[i].world.leg_residual, residuals[i % 2]);
    ASSERT_TRUE(one[i].walking);
    ASSERT_TRUE(three[i].walking);
    EXPECT_EQ(one[i].walking->evaluation.state_hash, three[i].walking->evaluation.state_hash);
  }
}

TEST(GaitMap, EndsWithTheFirstError)
{
  Quitter after_one(false);
  EXPECT_EQ(messageOf<std::runtime_error>(
                [&] {
                  mapGaits(shortLife(), { 0.0, 6.0 }, { 0.0 }, smallSearch(), 2, after_one);
                }),
            "enough");
  EXPECT_THROW(mapGaits(shortLife(), { 50.0 }, { 0.0 }, smallSearch(), 1, after_one), InvalidInput);
  GaitSearch endless;
  endless.climbing_steps = -1;
  EXPECT_EQ(messageOf<InvalidInput>([&] { endless.validate(); }),
            "climbing_steps is -1; it must lie within 0 to 1000000");
  GaitSearch nobody;
  nobody.random_robots = 0;
  EXPECT_EQ(messageOf<InvalidInput>([&] { nobody.validate(); }),
            "there are no known robots and random_robots is 0; a search begins with at least one robot");
}

TEST(GaitMap, StopsAtOnceWhenTold)
{
  Quitter at_once(true);
  GaitSearch search = smallSearch();
  search.random_robots = 100000;  // hours
  EXPECT_THROW(mapGaits(shortLife(), { 0.0 }, { 0.0 }, search, 1, at_once), EvaluationAbandoned);
}
}  // namespace
}  // namespace devo_evo
