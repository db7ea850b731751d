// What is recorded of a life (docs/physics.md 6): by hand-made courses of events, and by simulations watched from
// outside.
#include "soft_body/robots.h"

#include "soft_body/life_record.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace devo_evo;
using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{
constexpr double PI = 3.141592653589793;
constexpr double BIRTH = SETTLING_TIME;

Quaterniond about(const Vector3d& axis, double angle)
{
  return Quaterniond(AngleAxisd(angle, axis));
}

/// The measures of a body that begins in the first orientation and goes through the others.
double turnsThrough(const std::vector<Quaterniond>& orientations)
{
  LifeRecord life;
  life.beginLife(BIRTH, Vector3d::Zero(), orientations.front());
  for (const Quaterniond& orientation : orientations)
  {
    life.recordOrientation(orientation);
  }
  return life.evaluation(SoftBodySettings(), Vector3d::Zero(), 1).turns;
}

/// Twelve turns by 30 degrees about an axis of the world, of a body that stands in some way at first.
double turnsOfRevolution(const Vector3d& axis, const Quaterniond& first = Quaterniond::Identity())
{
  std::vector<Quaterniond> orientations;
  for (int i = 0; i <= 12; ++i)
  {
    orientations.push_back(about(axis, i * PI / 6.0) * first);
  }
  return turnsThrough(orientations);
}

/// Contacts of top voxels and of others in each step since birth; steps last 0.1 s.
Evaluation afterContacts(const std::vector<std::pair<int, int>>& contacts)
{
  LifeRecord life;
  life.beginLife(BIRTH, Vector3d::Zero(), Quaterniond::Identity());
  double time = BIRTH;
  for (const auto& [top, others] : contacts)
  {
    time += 0.1;
    life.recordContacts(time, top, others);
  }
  return life.evaluation(SoftBodySettings(), Vector3d::Zero(), 1);
}
}  // namespace

// ---- turns -------------------------------------------------------------------------------------------------------

TEST(Turns, arePositiveWhenRollingForwards)
{
  // Rolling towards +y, the top moves to +y and the front down: about -x
  EXPECT_NEAR(1.0, turnsOfRevolution(-Vector3d::UnitX()), 1e-12);
  EXPECT_NEAR(-1.0, turnsOfRevolution(Vector3d::UnitX()), 1e-12);
}

TEST(Turns, areAboutTheLateralAxisOfTheWorld)
{
  EXPECT_NEAR(0.0, turnsOfRevolution(Vector3d::UnitZ()), 1e-12);
  EXPECT_NEAR(0.0, turnsOfRevolution(Vector3d::UnitY()), 1e-12);
  // A body that has spun around to face backwards, and then rolls towards +y, still rolls forwards
  EXPECT_NEAR(1.0, turnsOfRevolution(-Vector3d::UnitX(), about(Vector3d::UnitZ(), PI)), 1e-12);
}

TEST(Turns, addUpAndCancel)
{
  std::vector<Quaterniond> rocking;
  for (const double angle : { 0.0, -1.0, -2.0, -1.5, -0.5, -1.0 })
  {
    rocking.push_back(about(Vector3d::UnitX(), angle));
  }
  EXPECT_NEAR(1.0 / (2.0 * PI), turnsThrough(rocking), 1e-12);
}

TEST(Turns, doNotDependOnTheSignOfQuaternions)
{
  const Quaterniond q = about(-Vector3d::UnitX(), 0.5);
  const Quaterniond minus_q(-q.w(), -q.x(), -q.y(), -q.z());
  EXPECT_NEAR(0.5 / (2.0 * PI), turnsThrough({ Quaterniond::Identity(), minus_q, q }), 1e-12);
}

// ---- contacts ----------------------------------------------------------------------------------------------------

TEST(TopContact, isTheFirstTouchOfTheTopLayer)
{
  EXPECT_FALSE(afterContacts({ { 0, 4 }, { 0, 0 } }).first_top_contact_since_birth_s.has_value());
  EXPECT_NEAR(0.2, *afterContacts({ { 0, 4 }, { 1, 4 }, { 5, 0 } }).first_top_contact_since_birth_s, 1e-12);
}

TEST(FellOver, isWhenMoreTopVoxelsTouchThanOthers)
{
  EXPECT_FALSE(afterContacts({ { 0, 4 }, { 3, 3 }, { 0, 0 } }).fell_over_since_birth_s.has_value());
  EXPECT_NEAR(0.3, *afterContacts({ { 0, 4 }, { 3, 3 }, { 4, 3 }, { 4, 0 } }).fell_over_since_birth_s, 1e-12);
}

TEST(Airborne, isTheShareOfStepsWithoutAnyContact)
{
  EXPECT_EQ(0.0, afterContacts({ { 0, 4 }, { 1, 0 } }).airborne_fraction);
  EXPECT_EQ(0.5, afterContacts({ { 0, 4 }, { 0, 0 }, { 0, 0 }, { 1, 0 } }).airborne_fraction);
}

// ---- displacement and windows ------------------------------------------------------------------------------------

TEST(Displacement, isFromBirthInVoxelsAndBodyLengths)
{
  SoftBodySettings settings;
  settings.voxel_size = 0.02;
  settings.grid_y = 5;
  LifeRecord life;
  life.beginLife(BIRTH, { 0.1, 0.2, 0.3 }, Quaterniond::Identity());
  life.recordContacts(BIRTH + 0.1, 0, 4);
  const Evaluation evaluation = life.evaluation(settings, { 0.13, 0.16, 0.5 }, 77);
  EXPECT_NEAR(-2.0, evaluation.displacement_y_voxels, 1e-12);
  EXPECT_NEAR(2.5, evaluation.displacement_xy_voxels, 1e-12);  // 3-4-5 triangle of 1.5 and 2 voxels
  EXPECT_NEAR(-0.4, evaluation.fitness, 1e-12);
  EXPECT_EQ(77u, evaluation.state_hash);
}

TEST(Windows, areAsManyAsBeginWithinTheLifetime)
{
  SoftBodySettings settings;
  settings.grid_x = settings.grid_y = settings.grid_z = 1;
  const auto windows = [&settings](double lifetime)
  {
    settings.lifetime = lifetime;
    return evaluate(settings, { uniformRobot(settings, 0.0) }).front().velocity_body_lengths_per_s.size();
  };
  EXPECT_EQ(1u, windows(0.001));
  EXPECT_EQ(1u, windows(0.4));
  EXPECT_EQ(1u, windows(0.5));
  EXPECT_EQ(2u, windows(0.6));
  EXPECT_EQ(2u, windows(1.0));
  EXPECT_EQ(3u, windows(1.25));
  EXPECT_EQ(20u, windows(10.0));
}

// ---- simulations watched from outside ----------------------------------------------------------------------------

namespace
{
/// The measures by their definitions, from the states of all voxels after each step.
class Onlooker
{
public:
  explicit Onlooker(const SoftBodySettings& settings) : settings_(settings) {}

  void watch(const Simulation& simulation)
  {
    const double time = simulation.time();
    const Vector3d center = simulation.centerOfMass(0);
    if (time <= BIRTH)
    {
      return;
    }
    if (!born_)
    {
      born_ = true;
      birth_center_ = window_center_ = center;
      window_start_ = time;
      orientation_ = simulation.meanOrientation(0);
    }
    countContacts(simulation);
    const Quaterniond now = simulation.meanOrientation(0);
    const AngleAxisd turn(now * orientation_.conjugate());
    turned_ -= turn.angle() * turn.axis().x();
    orientation_ = now;
    const double window_end = BIRTH + 0.5 * static_cast<double>(velocities_.size() + 1);
    if (time > window_end || (simulation.finished() && time > window_start_))
    {
      velocities_.push_back((center.y() - window_center_.y()) / (time - window_start_) / length());
      window_center_ = center;
      window_start_ = time;
    }
    center_ = center;
  }

  void expectSeen(const Evaluation& evaluation) const
  {
    EXPECT_NEAR((center_ - birth_center_).y() / length(), evaluation.fitness, 1e-12);
    EXPECT_NEAR((center_ - birth_center_).head<2>().norm() / settings_.voxel_size, evaluation.displacement_xy_voxels,
                1e-12);
    EXPECT_NEAR(airborne_ / steps_, evaluation.airborne_fraction, 1e-12);
    EXPECT_EQ(top_contact_, evaluation.first_top_contact_since_birth_s);
    EXPECT_EQ(fell_over_, evaluation.fell_over_since_birth_s);
    EXPECT_NEAR(turned_ / (2.0 * PI), evaluation.turns, 1e-4);  // which looks at every 16th step
    ASSERT_EQ(velocities_.size(), evaluation.velocity_body_lengths_per_s.size());
    for (size_t window = 0; window < velocities_.size(); ++window)
    {
      EXPECT_NEAR(velocities_[window], evaluation.velocity_body_lengths_per_s[window], 1e-12);
    }
  }

private:
  double length() const { return settings_.voxel_size * settings_.grid_y; }

  void countContacts(const Simulation& simulation)
  {
    int top = 0;
    int others = 0;
    const int per_layer = settings_.grid_x * settings_.grid_y;
    for (int i = 0; i < settings_.voxelCount(); ++i)
    {
      const VoxelState voxel = simulation.voxel(0, i);
      const bool touches = 0.5 * voxel.scale > voxel.position.z();
      (i / per_layer == settings_.grid_z - 1 ? top : others) += touches ? 1 : 0;
    }
    steps_ += 1.0;
    airborne_ += top + others == 0 ? 1.0 : 0.0;
    const double age = simulation.time() - BIRTH;
    top_contact_ = !top_contact_ && top > 0 ? age : top_contact_;
    fell_over_ = !fell_over_ && top > others ? age : fell_over_;
  }

  const SoftBodySettings settings_;
  bool born_ = false;
  Vector3d birth_center_, window_center_, center_;
  double window_start_ = 0.0;
  Quaterniond orientation_;
  double turned_ = 0.0;
  double steps_ = 0.0;
  double airborne_ = 0.0;
  std::optional<double> top_contact_;
  std::optional<double> fell_over_;
  std::vector<double> velocities_;
};

Evaluation watchedLife(const SoftBodySettings& settings, const DevelopmentalProgram& program)
{
  const std::unique_ptr<Simulation> simulation = makeSimulation(settings, { program }, InstructionSet::SCALAR);
  Onlooker onlooker(settings);
  while (!simulation->finished())
  {
    simulation->step();
    onlooker.watch(*simulation);
  }
  const Evaluation evaluation = simulation->evaluation(0);
  onlooker.expectSeen(evaluation);
  return evaluation;
}
}  // namespace

TEST(Life, ofARollerIsMeasuredAsDefined)
{
  // The champion of the rollers turns over twice in this time
  SoftBodySettings settings;
  settings.lifetime = 2.3;
  const Evaluation evaluation = watchedLife(settings, referenceGenomes()[35].program);
  EXPECT_GT(evaluation.turns, 2.0);
  EXPECT_GT(evaluation.displacement_y_voxels, 10.0);
  EXPECT_TRUE(evaluation.fell_over_since_birth_s.has_value());
  EXPECT_EQ(5u, evaluation.velocity_body_lengths_per_s.size());
}

TEST(Life, ofRandomRobotsIsMeasuredAsDefined)
{
  SoftBodySettings settings;
  settings.grid_x = 3;
  settings.grid_z = 2;
  settings.lifetime = 0.5;
  for (const uint64_t seed : { 1u, 2u, 3u })
  {
    SCOPED_TRACE(seed);
    watchedLife(settings, scrambledRobot(settings, seed));
  }
}

TEST(Life, inTheAirHasNoContacts)
{
  // Without weight a body that shrinks leaves the floor where it was
  SoftBodySettings settings;
  settings.gravity = 0.0;
  settings.lifetime = 0.1;
  const Evaluation evaluation = watchedLife(settings, uniformRobot(settings, -0.8));
  EXPECT_EQ(1.0, evaluation.airborne_fraction);
  EXPECT_FALSE(evaluation.first_top_contact_since_birth_s.has_value());
}

TEST(Life, ofASingleLayerHasOnlyATop)
{
  SoftBodySettings settings;
  settings.grid_z = 1;
  settings.lifetime = 0.1;
  const Evaluation evaluation = watchedLife(settings, uniformRobot(settings, 0.0));
  EXPECT_LT(*evaluation.first_top_contact_since_birth_s, settings.timeStep());
  EXPECT_LT(*evaluation.fell_over_since_birth_s, settings.timeStep());
}

TEST(Life, hasNoMeasuresBeforeBirth)
{
  const SoftBodySettings settings;
  const std::unique_ptr<Simulation> simulation = makeSimulation(settings, { scrambledRobot(settings, 1) });
  simulation->step();
  const Evaluation evaluation = simulation->evaluation(0);
  EXPECT_EQ(0.0, evaluation.fitness);
  EXPECT_EQ(0.0, evaluation.displacement_xy_voxels);
  EXPECT_EQ(0.0, evaluation.turns);
  EXPECT_EQ(0.0, evaluation.airborne_fraction);
  EXPECT_TRUE(evaluation.velocity_body_lengths_per_s.empty());
}
