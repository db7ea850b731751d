// Voxels of one body that are pressed together (docs/physics.md 3).
#include "soft_body/expect_vector.h"
#include "soft_body/hand_made_body.h"
#include "soft_body/robots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace devo_evo;
using Eigen::Vector3d;

namespace
{
/// A chain of five voxels along x, high above the floor and bent to a hairpin: its ends are four face-steps apart in
/// the lattice, just enough to collide, and `apart` metres apart in space. Its other voxels are out of their way.
class Hairpin : public HandMadeBody
{
public:
  explicit Hairpin(double apart) : HandMadeBody(weightlessSettings(5, 1, 1))
  {
    clock.first_step = true;
    setPosition(0, { 0.0, 0.0, 1.0 });
    setPosition(1, { 0.01, -0.003, 1.0 });
    setPosition(2, { 0.016, 0.5 * apart, 1.0 });
    setPosition(3, { 0.01, apart + 0.003, 1.0 });
    setPosition(4, { 0.0, apart, 1.0 });
  }

  /// What the collisions alone exert: the forces with them less the forces without.
  std::vector<Vector3d> collisionForces()
  {
    std::vector<Eigen::VectorXd> before;
    for (int voxel = 0; voxel < 5; ++voxel)
    {
      before.push_back(Eigen::Map<const Eigen::VectorXd>(&at(voxel, 0), VOXEL_FIELDS));
    }
    std::vector<Vector3d> forces = loadsOfStep().forces;
    for (int voxel = 0; voxel < 5; ++voxel)
    {
      Eigen::Map<Eigen::VectorXd>(&at(voxel, 0), VOXEL_FIELDS) = before[static_cast<size_t>(voxel)];
    }
    state().collision_pair_count = 0;
    const std::vector<Vector3d> without = loadsOfStep().forces;
    for (size_t voxel = 0; voxel < 5; ++voxel)
    {
      forces[voxel] -= without[voxel];
    }
    return forces;
  }
};

bool isListed(const CollisionList& list, int voxel_a, int voxel_b)
{
  return std::any_of(list.pairs().begin(), list.pairs().end(),
                     [voxel_a, voxel_b](const CollisionPair& pair)
                     { return pair.voxel_a == voxel_a && pair.voxel_b == voxel_b && (pair.robots & 1u) != 0; });
}

/// A list of collision pairs for one robot, whose voxels are held in hand-set places.
class ListFor
{
public:
  explicit ListFor(HandMadeBody& body) : body_(body), list_(body.lattice(), 0.01, 1, 1) {}

  const CollisionList& after(double max_speed, double dt)
  {
    const double square = max_speed * max_speed;
    list_.update(body_.state().voxels, &square, dt);
    return list_;
  }

private:
  HandMadeBody& body_;
  CollisionList list_;
};
}  // namespace

// ---- the force ---------------------------------------------------------------------------------------------------

TEST(Collision, pushesOverlappingVoxelsApart)
{
  // Contact distance 0.75 (1 cm + 1 cm) = 1.5 cm; at 1.4 cm, a1 * 1 mm = 50 N each, along the line of centres
  Hairpin body(0.014);
  body.listCollisions();
  const std::vector<Vector3d> forces = body.collisionForces();
  expectNear({ 0.0, -50.0, 0.0 }, forces[0], 1e-8);
  expectNear({ 0.0, 50.0, 0.0 }, forces[4], 1e-8);
  for (const size_t other : { 1u, 2u, 3u })
  {
    expectNear(Vector3d::Zero(), forces[other], 1e-8);
  }
}

TEST(Collision, isNoneBeyondTheContactDistance)
{
  Hairpin body(0.0151);
  body.listCollisions();
  EXPECT_EQ(1, body.state().collision_pair_count);
  expectNear(Vector3d::Zero(), body.collisionForces()[0], 0.0);
}

TEST(Collision, reachesAsFarAsTheVoxelsAreLargeNow)
{
  // 0.75 (1.2 cm + 1.6 cm) = 2.1 cm: at 2 cm they overlap by 1 mm
  Hairpin body(0.02);
  body.setScale(0, 0.012);
  body.setScale(4, 0.016);
  body.listCollisions();
  expectNear({ 0.0, -50.0, 0.0 }, body.collisionForces()[0], 1e-8);
}

TEST(Collision, hasNoDampingFrictionOrMoment)
{
  Hairpin body(0.014);
  body.listCollisions();
  body.setVelocity(0, { 0.5, 0.5, 0.5 });
  body.step();
  const Vector3d fast = body.velocity(0) - Vector3d(0.5, 0.5, 0.5);
  Hairpin at_rest(0.014);
  at_rest.listCollisions();
  at_rest.step();
  expectNear(at_rest.velocity(0), fast, 1e-12);
  EXPECT_EQ(at_rest.vectorAt(0, ANGULAR_MOMENTUM), body.vectorAt(0, ANGULAR_MOMENTUM));
}

TEST(Collision, separatesAPairPressedTogether)
{
  // Bond damping and collision together end with the ends apart: no overlap is left
  Hairpin body(0.012);
  for (int step = 0; step < 400; ++step)
  {
    body.listCollisions();
    body.step();
    body.clock.first_step = false;
  }
  EXPECT_GT((body.position(4) - body.position(0)).norm(), 0.0149);
}

// ---- which pairs -------------------------------------------------------------------------------------------------

TEST(CollisionList, holdsOnlyPairsMoreThanThreeFaceStepsApart)
{
  HandMadeBody body(weightlessSettings(6, 1, 1));
  for (int voxel = 0; voxel < 6; ++voxel)
  {
    body.setPosition(voxel, { 0.001 * voxel, 0.0, 1.0 });
  }
  ListFor list(body);
  std::vector<std::pair<int, int>> pairs;
  for (const CollisionPair& pair : list.after(0.0, 1.0).pairs())
  {
    pairs.emplace_back(pair.voxel_a, pair.voxel_b);
  }
  EXPECT_EQ((std::vector<std::pair<int, int>>{ { 0, 4 }, { 0, 5 }, { 1, 5 } }), pairs);
}

TEST(CollisionList, leavesInnerVoxelsOut)
{
  // 5x5x5 all in one place: every pair of surface voxels that is far enough apart in the lattice, no inner one
  HandMadeBody body(weightlessSettings(5, 5, 5));
  for (int voxel = 0; voxel < 125; ++voxel)
  {
    body.setPosition(voxel, { 0.0, 0.0, 1.0 });
  }
  ListFor list(body);
  const int inner = body.lattice().index(1, 1, 1);
  for (const CollisionPair& pair : list.after(0.0, 1.0).pairs())
  {
    ASSERT_TRUE(pair.voxel_a != inner && pair.voxel_b != inner);
    ASSERT_LT(pair.voxel_a, pair.voxel_b);
  }
  EXPECT_TRUE(isListed(list.after(0.0, 1.0), body.lattice().index(0, 0, 0), body.lattice().index(4, 4, 4)));
}

TEST(CollisionList, holdsPairsCloserThanTwiceTheFirstsSizeAndThreeVoxels)
{
  const auto listed_at = [](double apart, double size_a, double size_b)
  {
    Hairpin body(apart);
    body.setScale(0, size_a);
    body.setScale(4, size_b);
    ListFor list(body);
    return isListed(list.after(0.0, 1.0), 0, 4);
  };
  EXPECT_TRUE(listed_at(0.0199, 0.01, 0.01));
  EXPECT_FALSE(listed_at(0.0201, 0.01, 0.01));
  EXPECT_FALSE(listed_at(0.0201, 0.01, 0.0175));  // the higher voxel's size does not matter
  EXPECT_TRUE(listed_at(0.0299, 0.0175, 0.01));
  EXPECT_FALSE(listed_at(0.0301, 0.0175, 0.01));  // 2 s_a would be 3.5 cm
}

TEST(CollisionList, missesOverlapsOfASmallVoxelWithALargeHigherOne)
{
  // Contact distance 0.75 (0.5 cm + 1.75 cm) = 1.6875 cm, but listed below 2 s_a = 1 cm only. So does the reference.
  Hairpin body(0.012);
  body.setScale(0, 0.005);
  body.setScale(4, 0.0175);
  body.listCollisions();
  EXPECT_EQ(0, body.state().collision_pair_count);
}

TEST(CollisionList, isRenewedOnceTheBodyMayHaveMovedHalfAVoxel)
{
  Hairpin body(0.025);
  ListFor list(body);
  EXPECT_FALSE(isListed(list.after(0.0, 0.001), 0, 4));
  body.setPosition(4, { 0.0, 0.012, 1.0 });
  // 1.2 m/s for 1 ms each is 0.12 voxels a step: above 0.5 in the fifth
  for (int step = 1; step <= 4; ++step)
  {
    EXPECT_FALSE(isListed(list.after(1.2, 0.001), 0, 4)) << step;
  }
  EXPECT_TRUE(isListed(list.after(1.2, 0.001), 0, 4));
  // ... and counts from there again
  body.setPosition(4, { 0.0, 0.025, 1.0 });
  for (int step = 1; step <= 4; ++step)
  {
    EXPECT_TRUE(isListed(list.after(1.2, 0.001), 0, 4)) << step;
  }
  EXPECT_FALSE(isListed(list.after(1.2, 0.001), 0, 4));
}

TEST(CollisionList, findsInALargeBodyWhatTestingEveryPairFinds)
{
  // 7x7x7 crumpled to a third of its size, with voxels of all sizes; some far away, on negative coordinates too
  HandMadeBody body(weightlessSettings(7, 7, 7));
  const DevelopmentalProgram random = scrambledRobot(weightlessSettings(7, 7, 7), 4);
  const Lattice& lattice = body.lattice();
  for (int voxel = 0; voxel < lattice.voxelCount(); ++voxel)
  {
    const size_t i = static_cast<size_t>(voxel);
    const Vector3d direction(random.morphology_initial[i], random.morphology_final[i], random.control_initial[i]);
    body.setPosition(voxel, (voxel % 50 == 0 ? 1e17 : 0.04) * direction);
    body.setScale(voxel, 0.01 * (1.0 + 0.75 * random.control_final[i]));
  }
  std::vector<std::pair<int, int>> expected;
  for (const int a : lattice.surface())
  {
    for (const int b : lattice.surface())
    {
      const double apart = (body.position(b) - body.position(a)).norm();
      if (a < b && lattice.manhattanDistance(a, b) > 3 && apart < std::min(0.03, 2.0 * body.at(a, SCALE)))
      {
        expected.emplace_back(a, b);
      }
    }
  }
  EXPECT_GT(expected.size(), 500u);
  ListFor list(body);
  std::vector<std::pair<int, int>> actual;
  for (const CollisionPair& pair : list.after(0.0, 1.0).pairs())
  {
    actual.emplace_back(pair.voxel_a, pair.voxel_b);
  }
  EXPECT_EQ(expected, actual);
}

TEST(CollisionList, holdsNoPairThatIsNowhere)
{
  HandMadeBody body(weightlessSettings(7, 7, 7));
  for (int voxel = 0; voxel < 343; ++voxel)
  {
    body.setPosition(voxel, Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
  }
  ListFor list(body);
  EXPECT_TRUE(list.after(0.0, 1.0).pairs().empty());
}

TEST(CollisionList, isOneForAllRobotsOfABatchInAscendingOrder)
{
  // Two robots in two lanes: hairpins whose ends are close in the first, both, or the second, one after the other
  const int lanes = 2;
  const Lattice lattice(6, 1, 1);
  std::vector<double> voxels(6 * VOXEL_FIELDS * lanes, 0.0);
  const auto at = [&voxels](int voxel, int field, int robot) -> double&
  { return voxels[static_cast<size_t>((voxel * VOXEL_FIELDS + field) * lanes + robot)]; };
  const auto spread = [&at](int robot)
  {
    for (int voxel = 0; voxel < 6; ++voxel)
    {
      at(voxel, POSITION, robot) = 0.1 * voxel;
      at(voxel, SCALE, robot) = 0.01;
    }
  };
  const auto touch = [&at](int robot, int voxel_a, int voxel_b)
  { at(voxel_b, POSITION, robot) = at(voxel_a, POSITION, robot) + 0.01; };
  spread(0);
  spread(1);
  touch(0, 1, 5);
  touch(1, 0, 4);
  touch(1, 1, 5);
  CollisionList list(lattice, 0.01, lanes, 2);
  const std::vector<double> still(2, 0.0);
  list.update(voxels.data(), still.data(), 1.0);
  ASSERT_EQ(2u, list.pairs().size());
  EXPECT_EQ(4, list.pairs()[0].voxel_b);
  EXPECT_EQ(2u, list.pairs()[0].robots);
  EXPECT_EQ(5, list.pairs()[1].voxel_b);
  EXPECT_EQ(3u, list.pairs()[1].robots);

  // The second robot flies on and is listed anew; the first has not moved and is not
  spread(0);
  spread(1);
  touch(1, 0, 5);
  const std::vector<double> fast = { 0.0, 1.0 };
  list.update(voxels.data(), fast.data(), 1.0);
  ASSERT_EQ(2u, list.pairs().size());
  EXPECT_EQ(0, list.pairs()[0].voxel_a);
  EXPECT_EQ(5, list.pairs()[0].voxel_b);
  EXPECT_EQ(2u, list.pairs()[0].robots);
  EXPECT_EQ(1, list.pairs()[1].voxel_a);
  EXPECT_EQ(5, list.pairs()[1].voxel_b);
  EXPECT_EQ(1u, list.pairs()[1].robots);
}
