// One bond at a time, against beam theory done by hand (docs/physics.md 2). Numbers are in the bond's frame: x along
// the bond, from voxel 1 to voxel 2. With the default material, E = 5e6 Pa, nu = 0.35, L = 0.01 m and m = 1 kg:
//
//   a1 = E L             = 50,000 N/m    tension                  c_a1 = 2 sqrt(a1 m) = 447.214 N s/m
//   b1 = E L             = 50,000 N/m    shear                    c_b1 = 2 sqrt(b1 m) = 447.214 N s/m
//   b2 = E L^2 / 2       = 250 N         shear with rotation      c_b2 = 2 sqrt(b2 S) = 2.236068 N s
//   b3 = E L^3 / 6       = 5/6 N m       bending                  c_b3 = 2 sqrt(b3 I) = 7.45356e-3 N m s
//   a2 = G L^3 / 6       = 5/16.2 N m    torsion, G = E / 2.7     c_a2 = 2 sqrt(a2 I) = 4.53609e-3 N m s
#include "soft_body/expect_vector.h"
#include "soft_body/hand_made_body.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace devo_evo;
using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{
constexpr double PI = 3.141592653589793;
constexpr double L = 0.01;
constexpr double A1 = 50000.0;
constexpr double B2 = 250.0;
constexpr double B3 = 5.0 / 6.0;
constexpr double A2 = 5.0 / 16.2;
constexpr double THETA_S = 0.01732;  // leaves the small-angle regime at 1.1 times this
constexpr double TOLERANCE = 1e-9;   // rounding: forces are differences of positions (1 ulp of 0.5 m) times 5e4 N/m

/// The rotation vector as the model has it for angles below 0.098: 2 sin(b/2) sqrt(2 / (1 + cos(b/2))) = 4 sin(b/4).
double approximateAngle(double angle)
{
  return 4.0 * std::sin(angle / 4.0);
}

Quaterniond turn(double angle, const Vector3d& axis)
{
  return Quaterniond(AngleAxisd(angle, axis.normalized()));
}

/// Two voxels with a bond along each axis in turn.
class Bond : public testing::TestWithParam<int>
{
protected:
  Bond() : body_(settings(GetParam())) {}

  static SoftBodySettings settings(int axis)
  {
    return weightlessSettings(axis == 0 ? 2 : 1, axis == 1 ? 2 : 1, axis == 2 ? 2 : 1);
  }

  /// From the bond's frame to the world: a turn of the bond's axis from x.
  static Vector3d toWorld(const Vector3d& v)
  {
    const std::array<Vector3d, 3> in_world = { v, Vector3d(-v.y(), v.x(), v.z()), Vector3d(-v.z(), v.y(), v.x()) };
    return in_world[static_cast<size_t>(GetParam())];
  }

  static Vector3d fromWorld(const Vector3d& v)
  {
    return { v.dot(toWorld(Vector3d::UnitX())), v.dot(toWorld(Vector3d::UnitY())), v.dot(toWorld(Vector3d::UnitZ())) };
  }

  /// Voxel 1 half a metre above the floor; voxel 2 at r from it, turned by q from it; then everything turned as one.
  void place(const Vector3d& r, const Quaterniond& q = Quaterniond::Identity(),
             const Quaterniond& whole = Quaterniond::Identity())
  {
    body_.setPosition(0, Vector3d(0.0, 0.0, 0.5));
    body_.setPosition(1, Vector3d(0.0, 0.0, 0.5) + toWorld(whole * r));
    body_.setOrientation(0, inWorld(whole));
    body_.setOrientation(1, inWorld(whole * q));
  }

  static Quaterniond inWorld(const Quaterniond& q)
  {
    Quaterniond result;
    result.w() = q.w();
    result.vec() = toWorld(q.vec());
    return result;
  }

  struct Loads
  {
    Vector3d force_1, force_2, moment_1, moment_2;
  };

  /// Of the bond as placed, without damping: on the first step of a simulation.
  Loads elasticLoads()
  {
    body_.clock.first_step = true;
    return loads();
  }

  /// With damping of what has changed since the last placement.
  Loads dampedLoads()
  {
    body_.clock.first_step = false;
    return loads();
  }

  Loads loads()
  {
    const HandMadeBody::Loads all = body_.loadsOfStep();
    return { fromWorld(all.forces[0]), fromWorld(all.forces[1]), fromWorld(all.moments[0]), fromWorld(all.moments[1]) };
  }

  static void expectLoads(const Loads& expected, const Loads& actual, double tolerance = TOLERANCE)
  {
    expectNear(expected.force_1, actual.force_1, tolerance);
    expectNear(expected.force_2, actual.force_2, tolerance);
    expectNear(expected.moment_1, actual.moment_1, tolerance * L);
    expectNear(expected.moment_2, actual.moment_2, tolerance * L);
  }

  HandMadeBody body_;
};

const Vector3d NONE = Vector3d::Zero();
const Vector3d Y = Vector3d::UnitY();
const Vector3d Z = Vector3d::UnitZ();
const Vector3d X = Vector3d::UnitX();
}  // namespace

INSTANTIATE_TEST_SUITE_P(AlongEachAxis, Bond, testing::Values(0, 1, 2),
                         [](const testing::TestParamInfo<int>& axis) { return std::string(1, "xyz"[axis.param]); });

// ---- at rest, tension --------------------------------------------------------------------------------------------

TEST_P(Bond, atRestPullsNothing)
{
  place(L * X);
  expectLoads({ NONE, NONE, NONE, NONE }, elasticLoads());
}

TEST_P(Bond, pullsInTensionByTheStretchTimesItsStiffness)
{
  place(0.0101 * X);  // 0.1 mm too long: 50,000 N/m * 1e-4 m = 5 N, pulling each voxel to the other
  expectLoads({ 5.0 * X, -5.0 * X, NONE, NONE }, elasticLoads());
  EXPECT_TRUE(body_.smallAngle(0));
}

TEST_P(Bond, pushesInCompression)
{
  place(0.0098 * X);
  expectLoads({ -10.0 * X, 10.0 * X, NONE, NONE }, elasticLoads());
}

TEST_P(Bond, pullsAlikeInTheLargeAngleRegime)
{
  place(0.015 * X);  // 1.5 times as long as at rest: beyond 1.1 * 1.3
  expectLoads({ 250.0 * X, -250.0 * X, NONE, NONE }, elasticLoads());
  EXPECT_FALSE(body_.smallAngle(0));
}

TEST_P(Bond, restsAtTheMeanOfItsVoxelsSizesButStrainsOverTheNominalOne)
{
  body_.setScale(0, 0.008);
  body_.setScale(1, 0.015);
  place(0.0115 * X);
  expectLoads({ NONE, NONE, NONE, NONE }, elasticLoads());
  place(0.0125 * X);  // 1 mm too long: strain 0.1 of L (not 0.087 of the resting length), so 0.1 * E * L^2 = 50 N
  expectLoads({ 50.0 * X, -50.0 * X, NONE, NONE }, elasticLoads());
}

// ---- shear -------------------------------------------------------------------------------------------------------

TEST_P(Bond, resistsShearWithForceAndMoments)
{
  // Small-angle: F_y = b1 d_y = 5 N; both ends' moments are b2 d_y = 0.025 N m. They balance the couple 5 N * 0.01 m.
  place({ L, 1e-4, 0.0 });
  expectLoads({ 5.0 * Y, -5.0 * Y, 0.025 * Z, 0.025 * Z }, elasticLoads());
  place({ L, 0.0, 1e-4 });
  expectLoads({ 5.0 * Z, -5.0 * Z, -0.025 * Y, -0.025 * Y }, elasticLoads());
}

TEST_P(Bond, resistsLargeShearInTheFrameOfItsChord)
{
  // r = (1.6, 1.2) cm, a 3-4-5 triangle: 2 cm long, at theta = atan(3/4) = 0.643501 to voxel 1's x axis; voxels not
  // turned. Along the chord a1 (0.02 - 0.01) m = 500 N. Seen from the chord both ends are turned by -theta, so the
  // force across it is -b2 (-2 theta) = 321.7505 N, and each end's moment 3 b3 theta = 1.608753 N m.
  const double theta = 0.6435011087932844;
  const double across = 321.7505543966422;
  const double moment = 1.608752771983211;
  place({ 0.016, 0.012, 0.0 });
  Vector3d force = 500.0 * Vector3d(0.8, 0.6, 0.0) + across * Vector3d(-0.6, 0.8, 0.0);
  EXPECT_NEAR(across, 2.0 * B2 * theta, 1e-9);
  expectLoads({ force, -force, moment * Z, moment * Z }, elasticLoads());
  EXPECT_FALSE(body_.smallAngle(0));

  place({ 0.016, 0.0, 0.012 });
  force = 500.0 * Vector3d(0.8, 0.0, 0.6) + across * Vector3d(-0.6, 0.0, 0.8);
  expectLoads({ force, -force, -moment * Y, -moment * Y }, elasticLoads());
}

TEST_P(Bond, takesTheTurnOfItsChordToFirstOrderWhenNearlyStraight)
{
  // Voxel 2 is turned as the model turns the chord, and by 0.03 rad about it to stay in the large-angle regime. So
  // alpha_2 is that torsion alone, and the force across the chord is -b2 alpha_1z.
  const auto force_across = [this](double slope, double turn_of_chord)
  {
    const double angle = std::atan(slope);
    place(L * Vector3d(std::cos(angle), std::sin(angle), 0.0), turn(turn_of_chord, Z) * turn(0.03, X));
    body_.setSmallAngle(0, false);
    const double force = elasticLoads().force_1.dot(Vector3d(-std::sin(angle), std::cos(angle), 0.0));
    EXPECT_FALSE(body_.smallAngle(0));
    return force;
  };
  // Slope 0.0173 < theta_s: u = (1 - z^2 / 2, 0, 0, z) with z = -slope / 2, so alpha_1z = 2 z sqrt(2 / (1 + u_w)) =
  // -0.01730016, where the shortest arc would have -atan(0.0173) = -0.01729827.
  const double z = 0.0173 / 2.0;
  const double w = 1.0 - z * z / 2.0;
  EXPECT_NEAR(B2 * 2.0 * z * std::sqrt(2.0 / (1.0 + w)), force_across(0.0173, 2.0 * std::atan(z / w)), 1e-7);
  EXPECT_NEAR(B2 * 0.01730016, force_across(0.0173, 2.0 * std::atan(z / w)), 1e-5);
  // Slope 0.0174 > theta_s: the shortest arc, with rotvec's approximation near w = 1
  const double arc = std::atan(0.0174);
  EXPECT_NEAR(B2 * approximateAngle(arc), force_across(0.0174, arc), 1e-7);
}

// ---- bending -----------------------------------------------------------------------------------------------------

TEST_P(Bond, resistsTheRotationOfOneEnd)
{
  // Voxel 2 turned by 0.1 rad about z in its place: F_y = -b2 * 0.1 = -25 N; M_1 = b3 * 0.1, M_2 = 2 b3 * 0.1, and they
  // act with the opposite sign.
  place(L * X, turn(0.1, Z));
  expectLoads({ -25.0 * Y, 25.0 * Y, -0.1 * B3 * Z, -0.2 * B3 * Z }, elasticLoads());
  EXPECT_FALSE(body_.smallAngle(0));

  place(L * X, turn(0.1, Y));
  expectLoads({ 25.0 * Z, -25.0 * Z, -0.1 * B3 * Y, -0.2 * B3 * Y }, elasticLoads());
}

TEST_P(Bond, resistsASmallRotationOfOneEnd)
{
  place(L * X, turn(0.01, Z));
  const double angle = approximateAngle(0.01);
  expectLoads({ -B2 * angle * Y, B2 * angle * Y, -B3 * angle * Z, -2.0 * B3 * angle * Z }, elasticLoads());
  EXPECT_TRUE(body_.smallAngle(0));
}

TEST_P(Bond, bentToAnArcHasTheMomentOfItsCurvature)
{
  // A chord of length L at theta = atan(3/4), its ends turned by 0 and 2 theta: an arc of curvature 2 theta / L. Beam
  // theory: moment E J2 * 2 theta / L = b3 theta throughout, and no force. It straightens both ends.
  const double theta = 0.6435011087932844;
  place({ 0.008, 0.006, 0.0 }, turn(2.0 * theta, Z));
  expectLoads({ NONE, NONE, B3 * theta * Z, -B3 * theta * Z }, elasticLoads());
}

// ---- torsion, and the three branches of rotvec ---------------------------------------------------------------------

TEST_P(Bond, resistsTorsion)
{
  for (const double angle : { 0.0981, 0.5, -0.5, PI / 2.0, 1.6, 3.0, 3.5, 6.0 })
  {
    SCOPED_TRACE(angle);
    place(L * X, turn(angle, X));
    expectLoads({ NONE, NONE, A2 * angle * X, -A2 * angle * X }, elasticLoads());
  }
}

TEST_P(Bond, resistsTorsionSlightlyLessWhenTheAngleIsSmall)
{
  // w > 0.9988 is an angle below 0.09798; the approximation is b^2 / 96 too small: 1e-4 at most.
  for (const double angle : { 1e-6, 0.01, -0.01, 0.05, 0.0979 })
  {
    SCOPED_TRACE(angle);
    place(L * X, turn(angle, X));
    const double moment = A2 * approximateAngle(angle);
    expectLoads({ NONE, NONE, moment * X, -moment * X }, elasticLoads());
  }
}

TEST_P(Bond, seesNoRotationWhereTheCosineRoundsToOne)
{
  // Half of 2e-8 rad has the cosine 1 - 5e-17, which is 1 as a double; that of 4e-8 rad is 1 - 2.2e-16.
  place(L * X, turn(2e-8, X));
  expectLoads({ NONE, NONE, NONE, NONE }, elasticLoads(), 1e-12);
  place(L * X, turn(4e-8, X));
  const double moment = A2 * 4e-8;
  expectLoads({ NONE, NONE, moment * X, -moment * X }, elasticLoads(), 1e-12);
}

TEST_P(Bond, seesNoRotationAfterAFullTurn)
{
  Quaterniond full_turn(-1.0, 0.0, 0.0, 0.0);
  place(L * X, full_turn);
  expectLoads({ NONE, NONE, NONE, NONE }, elasticLoads());
}

// ---- frames ------------------------------------------------------------------------------------------------------

TEST_P(Bond, doesNotCareWhereTheWorldIs)
{
  const Quaterniond whole = turn(2.1, Vector3d(1.0, -2.0, 0.5));
  const std::array<std::pair<Vector3d, Quaterniond>, 4> states = {
    std::pair{ Vector3d(0.0103, 1e-4, -2e-4), turn(0.01, Vector3d(1.0, 2.0, 3.0)) },     // small-angle
    std::pair{ Vector3d(0.0103, 1e-4, -2e-4), turn(0.03, Vector3d(1.0, 2.0, 3.0)) },     // large-angle, nearly straight
    std::pair{ Vector3d(0.0103, 0.002, -0.003), turn(0.5, Vector3d(1.0, 2.0, 3.0)) },    // large-angle
    std::pair{ Vector3d(-0.0103, 0.002, -0.003), turn(2.5, Vector3d(1.0, -2.0, 3.0)) },  // turned inside out
  };
  for (const auto& [r, q] : states)
  {
    SCOPED_TRACE(r.transpose());
    const auto apply = [this, &r = r, &q = q](const Quaterniond& turned_as_one)
    {
      place(r, q, turned_as_one);
      body_.setSmallAngle(0, true);
      return elasticLoads();
    };
    const Loads upright = apply(Quaterniond::Identity());
    const Loads turned = apply(whole);
    EXPECT_GT(upright.force_1.norm(), 1.0);
    expectLoads(
        { whole * upright.force_1, whole * upright.force_2, whole * upright.moment_1, whole * upright.moment_2 },
        turned);
  }
}

TEST_P(Bond, loadsBothVoxelsOppositely)
{
  place({ 0.011, 0.004, -0.003 }, turn(0.7, Vector3d(1.0, -1.0, 2.0)));
  const Loads result = elasticLoads();
  EXPECT_EQ(-result.force_1, result.force_2);
}

TEST_P(Bond, pointingBackwardsIsNotTurnedAround)
{
  // |r'_y / r'_x| is far below theta_s here too, so the first-order form applies, and turns by (almost) nothing: the
  // bond acts as if r' were (+0.8 L, 0, 0). So does the reference.
  place(-0.8 * L * X, turn(0.1, X));
  body_.setSmallAngle(0, false);
  expectLoads({ -100.0 * X, 100.0 * X, 0.1 * A2 * X, -0.1 * A2 * X }, elasticLoads());
}

// ---- damping -----------------------------------------------------------------------------------------------------

TEST_P(Bond, dampsTension)
{
  // Stretched by 1 um in one step of 2.49117e-4 s: F += c_a1 / 2 * v = 223.607 N s/m * 4.01418e-3 m/s = 0.897598 N.
  place(L * X);
  expectLoads({ NONE, NONE, NONE, NONE }, elasticLoads());
  place((L + 1e-6) * X);
  const double force = A1 * 1e-6 + std::sqrt(50000.0) * 1e-6 / body_.model().dt;
  EXPECT_NEAR(0.05 + 0.897598, force, 1e-6);
  expectLoads({ force * X, -force * X, NONE, NONE }, dampedLoads());
}

TEST_P(Bond, dampsShear)
{
  // d_y changes by 1 um: force c_b1 / 2 * v, end moments c_b2 / 4 * v.
  place(L * X);
  elasticLoads();
  place({ L, 1e-6, 0.0 });
  const double speed = 1e-6 / body_.model().dt;
  const double force = 0.05 + 0.5 * 447.2135954999579 * speed;
  const double moment = 250e-6 + 0.25 * 2.23606797749979 * speed;
  expectLoads({ force * Y, -force * Y, moment * Z, moment * Z }, dampedLoads());
}

TEST_P(Bond, dampsBending)
{
  // alpha_2z changes by 1e-4 rad: forces -c_b2 / 2 * w, moments c_b3 / 4 * (w, 2 w).
  place(L * X);
  elasticLoads();
  place(L * X, turn(1e-4, Z));
  const double angle = approximateAngle(1e-4);
  const double rate = angle / body_.model().dt;
  const double force = B2 * angle + 0.5 * 2.23606797749979 * rate;
  const double moment = B3 * angle + 0.25 * 7.453559924999299e-3 * rate;
  expectLoads({ -force * Y, force * Y, -moment * Z, -2.0 * moment * Z }, dampedLoads());
}

TEST_P(Bond, dampsTorsion)
{
  place(L * X);
  elasticLoads();
  place(L * X, turn(1e-4, X));
  const double angle = approximateAngle(1e-4);
  const double c_a2 = 2.0 * std::sqrt(A2 * (1e-4 / 6.0));
  const double moment = A2 * angle + 0.25 * c_a2 * angle / body_.model().dt;
  expectLoads({ NONE, NONE, moment * X, -moment * X }, dampedLoads());
}

TEST_P(Bond, dampsByItsRatio)
{
  SoftBodySettings undamped = settings(GetParam());
  undamped.bond_damping = 0.0;
  HandMadeBody body(undamped);
  body.setPosition(0, { 0.0, 0.0, 0.5 });
  body.clock.first_step = true;
  body.setPosition(1, Vector3d(0.0, 0.0, 0.5) + toWorld(L * X));
  body.loadsOfStep();
  body.clock.first_step = false;
  body.setPosition(0, { 0.0, 0.0, 0.5 });
  body.setPosition(1, Vector3d(0.0, 0.0, 0.5) + toWorld({ 0.0101, 1e-4, 0.0 }));
  expectNear({ 5.0, 5.0, 0.0 }, fromWorld(body.loadsOfStep().forces[0]), TOLERANCE);
}

// ---- regimes -----------------------------------------------------------------------------------------------------

TEST_P(Bond, changesItsRegimeByAngleWithHysteresis)
{
  const auto is_small_after = [this](double angle)
  {
    place(L * X, turn(angle, X));
    elasticLoads();
    return body_.smallAngle(0);
  };
  EXPECT_TRUE(is_small_after(0.0));
  EXPECT_TRUE(is_small_after(1.05 * THETA_S));
  EXPECT_TRUE(is_small_after(1.0999 * THETA_S));
  EXPECT_FALSE(is_small_after(1.1001 * THETA_S));
  EXPECT_FALSE(is_small_after(1.05 * THETA_S));
  EXPECT_FALSE(is_small_after(1.0001 * THETA_S));
  EXPECT_TRUE(is_small_after(0.9999 * THETA_S));
  EXPECT_TRUE(is_small_after(1.05 * THETA_S));
}

TEST_P(Bond, changesItsRegimeByStretchWithHysteresis)
{
  body_.setScale(0, 0.018);
  body_.setScale(1, 0.006);  // resting distance 1.2 cm
  const auto is_small_after = [this](double stretch)
  {
    place(0.012 * stretch * X);
    elasticLoads();
    return body_.smallAngle(0);
  };
  EXPECT_TRUE(is_small_after(1.0));
  EXPECT_TRUE(is_small_after(1.4299));
  EXPECT_FALSE(is_small_after(1.4301));
  EXPECT_FALSE(is_small_after(1.3001));
  EXPECT_TRUE(is_small_after(1.2999));
}

TEST_P(Bond, doesNotCountSidewaysBendingAmongItsRegimesUnlessAsked)
{
  place({ L, 0.5 * L, 0.3 * L });
  elasticLoads();
  EXPECT_TRUE(body_.smallAngle(0));
}

TEST_P(Bond, changesItsRegimeBySidewaysBendingWithHysteresisIfAsked)
{
  SoftBodySettings with_test = settings(GetParam());
  with_test.sideways_bend_test = true;
  HandMadeBody body(with_test);
  body.clock.first_step = true;
  const auto is_small_after = [&body](double y, double z)
  {
    body.setPosition(0, { 0.0, 0.0, 0.5 });
    body.setPosition(1, Vector3d(0.0, 0.0, 0.5) + toWorld(L * Vector3d(1.0, y, z)));
    body.loadsOfStep();
    return body.smallAngle(0);
  };
  EXPECT_TRUE(is_small_after(0.0, 0.0));
  EXPECT_TRUE(is_small_after(0.0349, -0.02));  // |y| + |z| = 0.0549 of x: leaves above 1.1 * 0.05
  EXPECT_FALSE(is_small_after(-0.0351, 0.02));
  EXPECT_FALSE(is_small_after(0.0301, 0.02));  // returns below 0.05
  EXPECT_TRUE(is_small_after(0.0299, 0.02));
}

TEST_P(Bond, doesNotDampOnASwitchStepAndKeepsItsMemory)
{
  place(L * X);
  elasticLoads();  // remembers d = 0, alpha = 0
  place(0.0101 * X, turn(0.02, X));
  const double small_angle = approximateAngle(0.02);
  expectLoads({ 5.0 * X, -5.0 * X, A2 * small_angle * X, -A2 * small_angle * X }, dampedLoads());
  EXPECT_FALSE(body_.smallAngle(0));

  // The next step damps its change since the memory, two steps ago, as if it had happened in one.
  place(0.0102 * X, turn(0.02, X));
  const double force = 10.0 + 0.5 * 447.2135954999579 * 2e-4 / body_.model().dt;
  const double c_a2 = 2.0 * std::sqrt(A2 * (1e-4 / 6.0));
  const double moment = A2 * small_angle + 0.25 * c_a2 * small_angle / body_.model().dt;
  expectLoads({ force * X, -force * X, moment * X, -moment * X }, dampedLoads());
}

TEST_P(Bond, remembersTheFirstStepOfASimulationEvenIfItSwitches)
{
  place(0.015 * X);
  elasticLoads();
  EXPECT_FALSE(body_.smallAngle(0));
  place(0.015 * X);
  expectLoads({ 250.0 * X, -250.0 * X, NONE, NONE }, dampedLoads());
}

// ---- motion ------------------------------------------------------------------------------------------------------

TEST(TwoVoxels, oscillateOnAnUndampedBondAtItsFrequency)
{
  // Reduced mass m / 2: omega = sqrt(2 a1 / m) = 316.228 rad/s. The semi-implicit step makes the period of
  // x'' = -omega^2 x such that sin(omega' dt / 2) = omega dt / 2.
  SoftBodySettings settings = weightlessSettings(1, 2, 1);
  settings.bond_damping = 0.0;
  HandMadeBody body(settings);
  body.clock.first_step = true;
  body.setPosition(0, { 0.0, 0.0, 0.5 });
  body.setPosition(1, { 0.0, 0.0101, 0.5 });
  const double dt = body.model().dt;
  const double omega = 2.0 * std::asin(std::sqrt(2.0 * A1) * dt / 2.0) / dt;
  for (int step = 1; step <= 1000; ++step)
  {
    body.step();
    body.clock.first_step = false;
    // x_n = c cos(omega (n + 1/2) dt) with x_0 = x_-1 = 1e-4, since it starts at rest
    const double expected = 1e-4 * std::cos(omega * (step + 0.5) * dt) / std::cos(omega * 0.5 * dt);
    ASSERT_NEAR(expected, (body.position(1) - body.position(0)).y() - L, 1e-12) << "step " << step;
  }
}

// ---- divergence --------------------------------------------------------------------------------------------------

TEST_P(Bond, divergesAboveAStrainOf100)
{
  place(1.0099 * X);  // strain (1.0099 - 0.01) / 0.01 = 99.99
  elasticLoads();
  EXPECT_EQ(0u, body_.state().diverged & 1u);
  place(1.0101 * X);
  elasticLoads();
  EXPECT_EQ(1u, body_.state().diverged & 1u);
  EXPECT_EQ(0, body_.state().diverged_bond[0]);
  EXPECT_NEAR(100.01, body_.state().diverged_strain[0], 1e-9);
}

TEST_P(Bond, divergesWithoutANumber)
{
  place(std::numeric_limits<double>::quiet_NaN() * X);
  elasticLoads();
  EXPECT_EQ(1u, body_.state().diverged & 1u);
  EXPECT_TRUE(std::isnan(body_.state().diverged_strain[0]));
}

TEST(Divergence, namesTheLowestBond)
{
  // 3x1x1: bond 0 joins voxels 0 and 1, bond 1 voxels 1 and 2
  HandMadeBody body(weightlessSettings(3, 1, 1));
  body.clock.first_step = true;
  for (int voxel = 0; voxel < 3; ++voxel)
  {
    body.setPosition(voxel, { 0.01 * voxel, 0.0, 0.5 });
  }
  body.setPosition(2, { 5.02, 0.0, 0.5 });
  body.step();
  EXPECT_EQ(1u, body.state().diverged);
  EXPECT_EQ(1, body.state().diverged_bond[0]);
  EXPECT_NEAR(500.0, body.state().diverged_strain[0], 1e-9);

  HandMadeBody both(weightlessSettings(3, 1, 1));
  both.clock.first_step = true;
  both.setPosition(0, { 0.0, 0.0, 0.5 });
  both.setPosition(1, { 2.01, 0.0, 0.5 });
  both.setPosition(2, { 9.01, 0.0, 0.5 });
  both.step();
  EXPECT_EQ(0, both.state().diverged_bond[0]);
  EXPECT_NEAR(200.0, both.state().diverged_strain[0], 1e-9);
}
