#pragma once

#include "devo_evo/rigid_body/quadruped_program.h"
#include "devo_evo/rigid_body/settings.h"

#include <Eigen/Geometry>

#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace devo_evo
{
/// The outcome of one quadruped's life: a pure function of program and settings on one build of ODE.
struct QuadrupedEvaluation
{
  static constexpr double NONE = std::numeric_limits<double>::quiet_NaN();

  bool valid = false;  ///< false if the simulation ran out of all bounds; the numbers are then NaN, empty or 0

  double fitness = NONE;            ///< mean over the steps of the light's intensity at the abdomen's centre [1/m^2]
  double descent = NONE;            ///< displacement of the abdomen down the slope, from birth to the end [m]
  double sideways = NONE;           ///< its displacement along +x, to the right [m]
  double turns = NONE;              ///< of the abdomen about the lateral axis [full turns]; positive: rolling downhill
  double abdomen_contact = NONE;    ///< share of the steps at which the abdomen touches the floor [1]
  double leg_contact = NONE;        ///< share of the steps at which a leg touches the floor [1]
  double airborne_fraction = NONE;  ///< share of the steps at which nothing touches the floor [1]

  std::optional<double> first_abdomen_contact_s;  ///< since birth [s]; none: never

  /// When the abdomen had first turned downhill by half a turn, since birth [s]; none: never.
  std::optional<double> first_roll_s;
  std::vector<double>
      velocity;  ///< of the abdomen down the slope, mean per window of 0.5 s; the last ends with life [m/s]

  uint64_t state_hash = 0;             ///< of the final state of every part; 0 if invalid
  std::optional<int64_t> failed_step;  ///< at which an invalid simulation was given up, counted from 1
};

/// A part of the robot. World frame: right-handed, z up; the floor passes through the origin and descends towards +y.
struct PartState
{
  Eigen::Vector3d position;          ///< centre [m]
  Eigen::Quaterniond orientation;    ///< part to world; a leg's own z axis points to its foot
  Eigen::Vector3d velocity;          ///< [m/s]
  Eigen::Vector3d angular_velocity;  ///< in world frame [rad/s]
};

/// The inverse-square law: intensity at a distance from a light of intensity 1 at 1 m [1/m^2]. Nothing occludes it.
double lightIntensity(const Eigen::Vector3d& light, const Eigen::Vector3d& sensor);

/// One quadruped living its life, in an ODE world of its own. Not thread-safe, and used by the thread that made it
/// only; different simulations are independent.
class QuadrupedSimulation
{
public:
  /// @throw InvalidInput if program or settings are invalid.
  QuadrupedSimulation(const RigidBodySettings& settings, const QuadrupedProgram& program);
  ~QuadrupedSimulation();

  /// Advances by one time step. @pre !finished()
  void step();

  /// Whether the lifetime is over, or the simulation has been given up.
  bool finished() const;

  int64_t stepCount() const;
  double time() const;  ///< since birth [s]

  PartState abdomen() const;

  /// The rod of a leg: a cylinder of length rodLength() between two half spheres, along its own z axis.
  PartState leg(size_t leg) const;
  double rodLength() const;  ///< without the half spheres [m]

  double hingeAngle(size_t leg) const;  ///< [rad]; positive: the foot swings to the front
  double legLength(size_t leg) const;   ///< as the actuator has it now [1, 0 to 1]

  bool abdomenTouches() const;          ///< the floor, in the last step
  bool legTouches(size_t leg) const;    ///< the floor, in the last step
  Eigen::Vector3d light() const;        ///< where the light stands [m]
  Eigen::Vector3d floorNormal() const;  ///< upwards [1]

  /// Kinetic and potential energy of all parts, without that of the contacts [J]. Zero height: the origin's.
  double mechanicalEnergy() const;

  /// Results over the life so far; those of evaluateQuadruped() once finished().
  QuadrupedEvaluation evaluation() const;

private:
  class World;
  std::unique_ptr<World> world_;
};

/// Simulates a whole life on the calling thread.
/// @param stop if given, looked at in every step; once true, EvaluationAbandoned is thrown.
/// @throw InvalidInput if program or settings are invalid.
QuadrupedEvaluation evaluateQuadruped(const RigidBodySettings& settings, const QuadrupedProgram& program,
                                      const std::atomic<bool>* stop = nullptr);
}  // namespace devo_evo
