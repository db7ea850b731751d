// Against the outputs of the authors' own simulator in test/data (docs/physics.md, "Agreement with the reference").
#include "devo_evo/soft_body/simulation.h"
#include "devo_evo/soft_body/text.h"

#include "soft_body/reference_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>

using namespace devo_evo;
using nlohmann::json;

namespace
{
constexpr int VOXELS = 48;
constexpr double VOXEL_SIZE = 0.01;

/// Above this sensitivity (voxels in ten seconds) two implementations may end in different phases of a roll.
constexpr double CALM = 0.1;

double largestDifference(const Eigen::VectorXd& actual, const json& expected)
{
  double largest = 0.0;
  for (Eigen::Index i = 0; i < actual.size(); ++i)
  {
    largest = std::max(largest, std::abs(actual[i] - expected[static_cast<size_t>(i)].get<double>()));
  }
  return largest;
}

/// Largest differences of any voxel from the reference, SI units.
struct StateErrors
{
  double position = 0.0, orientation = 0.0, velocity = 0.0, angular_velocity = 0.0, scale = 0.0;
  int static_friction = 0;  ///< number of voxels
};

StateErrors stateErrors(const Simulation& simulation, int robot, const json& state)
{
  StateErrors errors;
  for (int i = 0; i < VOXELS; ++i)
  {
    const size_t v = static_cast<size_t>(i);
    const VoxelState voxel = simulation.voxel(robot, i);
    const Eigen::Quaterniond& q = voxel.orientation;
    const auto raise = [](double& error, double candidate) { error = std::max(error, candidate); };
    raise(errors.position, largestDifference(voxel.position, state["position_m"][v]));
    raise(errors.orientation,
          largestDifference(Eigen::Vector4d(q.w(), q.x(), q.y(), q.z()), state["quaternion_wxyz"][v]));
    raise(errors.velocity, largestDifference(voxel.velocity, state["velocity_m_s"][v]));
    raise(errors.angular_velocity, largestDifference(voxel.angular_velocity, state["angular_velocity_rad_s"][v]));
    raise(errors.scale, std::abs(voxel.scale - state["scale_m"][v].get<double>()));
    errors.static_friction += voxel.static_friction != state["static_friction"][v].get<bool>() ? 1 : 0;
  }
  return errors;
}

int voxelsTouchingFloor(const Simulation& simulation, int robot)
{
  int touching = 0;
  for (int i = 0; i < VOXELS; ++i)
  {
    const VoxelState voxel = simulation.voxel(robot, i);
    touching += 0.5 * voxel.scale - voxel.position.z() > 0.0 ? 1 : 0;
  }
  return touching;
}

/// A reference robot's whole life: what we found, and how far its centre of mass strayed from the reference.
struct Life
{
  json reference;
  Evaluation evaluation;
  int touching_at_end = 0;
  double trace_error = 0.0;  ///< [m]
  size_t trace_points = 0;
  size_t reference_points = 0;

  double sensitivity() const { return reference["sensitivity_voxels"]; }
  double tolerance() const { return 10.0 * sensitivity() + 1e-5; }
  double errorY() const { return evaluation.displacement_y_voxels - reference["displacement_y_voxels"].get<double>(); }
  double errorXy() const
  {
    return evaluation.displacement_xy_voxels - reference["displacement_xy_voxels"].get<double>();
  }
};

/// Compares the centre of mass where the reference has a point at the present time.
void compareTrace(const Simulation& simulation, int robot, const json& points, Life& life)
{
  if (life.trace_points == points.size())
  {
    return;
  }
  const json& point = points[life.trace_points];
  if (std::abs(point[0].get<double>() - simulation.time()) < 1e-9)
  {
    const json expected = { point[1], point[2], point[3] };
    life.trace_error = std::max(life.trace_error, largestDifference(simulation.centerOfMass(robot), expected));
    ++life.trace_points;
  }
}

/// Simulates the lives of the first robots, calling watch(simulation, robot of it, index among all) after each step.
template <class Watch>
void simulateLives(const std::vector<ReferenceGenome>& genomes, size_t count, Watch watch)
{
  const size_t lanes = static_cast<size_t>(laneCount(bestInstructionSet()));
  for (size_t first = 0; first < count; first += lanes)
  {
    const size_t last = std::min(first + lanes, count);
    std::vector<DevelopmentalProgram> programs;
    for (size_t i = first; i < last; ++i)
    {
      programs.push_back(genomes[i].program);
    }
    const std::unique_ptr<Simulation> simulation = makeSimulation(SoftBodySettings(), programs);
    while (!simulation->finished())
    {
      simulation->step();
      for (size_t i = first; i < last; ++i)
      {
        watch(*simulation, static_cast<int>(i - first), i);
      }
    }
  }
}

/// All 36 lives.
std::vector<Life> referenceLives()
{
  const std::vector<ReferenceGenome> genomes = referenceGenomes();
  const std::vector<json> results = referenceLines("results.jsonl");
  const std::vector<json> traces = referenceLines("traces.jsonl");
  std::vector<Life> lives(genomes.size());
  for (size_t i = 0; i < genomes.size(); ++i)
  {
    EXPECT_EQ(genomes[i].id, results[i]["id"]);
    EXPECT_EQ(genomes[i].id, traces[i]["id"]);
    lives[i].reference = results[i];
    lives[i].reference_points = traces[i]["center_of_mass"].size();
  }
  simulateLives(genomes, genomes.size(),
                [&](const Simulation& simulation, int robot, size_t i)
                {
                  compareTrace(simulation, robot, traces[i]["center_of_mass"], lives[i]);
                  if (simulation.finished())
                  {
                    lives[i].evaluation = simulation.evaluation(robot);
                    lives[i].touching_at_end = voxelsTouchingFloor(simulation, robot);
                  }
                });
  return lives;
}

/// A row of the table in docs/physics.md.
std::string tableRow(const Life& life)
{
  std::array<char, 200> row{};
  std::snprintf(row.data(), row.size(), "| %s | %.6f | %.1e | %.1e | %.0e | %.1e |",
                life.reference["id"].get<std::string>().c_str(), life.reference["displacement_y_voxels"].get<double>(),
                life.errorY(), life.errorXy(), life.tolerance(), life.trace_error);
  return row.data();
}

void expectFellOver(const Life& life)
{
  const json& expected = life.reference["fell_over_since_birth_s"];
  const std::optional<double>& actual = life.evaluation.fell_over_since_birth_s;
  ASSERT_EQ(!expected.is_null(), actual.has_value());
  if (actual)
  {
    // An error of the tolerance at the end of a life of rolling, at 20 voxels per second, is this much time
    const double phase = life.sensitivity() < CALM ? 0.0 : life.tolerance() / 20.0;
    EXPECT_NEAR(expected.get<double>(), *actual, 1.01 * SoftBodySettings().timeStep() + phase);
  }
}
}  // namespace

TEST(Reference, statesOfTheFirstGenomes)
{
  const std::vector<ReferenceGenome> genomes = referenceGenomes();
  const std::vector<json> lines = referenceLines("states.jsonl");
  const std::vector<json> results = referenceLines("results.jsonl");
  ASSERT_EQ(8u, lines.size());
  std::vector<size_t> next(lines.size(), 0);
  simulateLives(genomes, lines.size(),
                [&](const Simulation& simulation, int robot, size_t i)
                {
                  const json& states = lines[i]["states"];
                  if (next[i] == states.size() || states[next[i]]["step"].get<int64_t>() != simulation.stepCount())
                  {
                    return;
                  }
                  SCOPED_TRACE(genomes[i].id + " at step " + toText(simulation.stepCount()));
                  const json& state = states[next[i]];
                  const StateErrors errors = stateErrors(simulation, robot, state);
                  EXPECT_EQ(genomes[i].id, lines[i]["id"]);
                  EXPECT_NEAR(state["time_s"].get<double>(), simulation.time(), 1e-15);
                  // Errors grow with time; the life as a whole is allowed 10 times the sensitivity and 1e-5 voxels.
                  // Turns, speeds and lengths are allowed what positions off by that much go along with, ten times what
                  // they are.
                  const bool early = simulation.stepCount() <= 2409;
                  const double sensitivity = results[i]["sensitivity_voxels"];
                  const double position = early ? 1e-10 : (10.0 * sensitivity + 1e-5) * VOXEL_SIZE;
                  EXPECT_LE(errors.position, position);
                  EXPECT_LE(errors.orientation, 50.0 * position);
                  EXPECT_LE(errors.velocity, 2000.0 * position);
                  EXPECT_LE(errors.angular_velocity, 50000.0 * position);
                  EXPECT_LE(errors.scale,
                            early ? 1e-9 : 1e-8);  // the reference has sizes and phases in single precision
                  EXPECT_EQ(0, errors.static_friction);
                  ++next[i];
                });
  for (const size_t compared : next)
  {
    EXPECT_EQ(9u, compared);
  }
}

TEST(Reference, livesOfAllGenomes)
{
  const std::vector<Life> lives = referenceLives();
  ASSERT_EQ(36u, lives.size());
  std::cout << "| genome | displacement along y | error | error in the plane | tolerance | trace |\n";
  for (const Life& life : lives)
  {
    SCOPED_TRACE(life.reference["id"].get<std::string>());
    std::cout << tableRow(life) << std::endl;
    ASSERT_TRUE(life.evaluation.valid);
    EXPECT_LE(std::abs(life.errorY()), life.tolerance());
    EXPECT_LE(std::abs(life.errorXy()), life.tolerance());
    EXPECT_EQ(life.reference_points, life.trace_points);
    // On the way the reference may be more sensitive than at the end: a hundred times the least tolerance, 1 um
    EXPECT_LE(life.trace_error, (life.tolerance() + 1e-4) * VOXEL_SIZE);
    expectFellOver(life);
    if (life.sensitivity() < CALM)
    {
      EXPECT_EQ(life.reference["voxels_touching_floor_at_end"].get<int>(), life.touching_at_end);
    }
  }
}
