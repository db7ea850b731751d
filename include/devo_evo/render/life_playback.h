#pragma once

#include "devo_evo/bodies/bodies.h"
#include "devo_evo/soft_body/developmental_program.h"
#include "devo_evo/soft_body/evaluation.h"

#include <Eigen/Geometry>

#include <atomic>
#include <memory>
#include <vector>

namespace devo_evo
{
/// A part of a robot as it is shown: a voxel of a soft body; of the quadruped, its abdomen, then its legs. World frame:
/// right-handed, z up.
struct ShownPart
{
  Eigen::Vector3d position;        ///< centre [m]
  Eigen::Quaterniond orientation;  ///< part to world
  double present_length;           ///< edge of a voxel, with actuation; by how much a leg protrudes [m]
  double resting_length;           ///< what development wants it to be now: without actuation [m]
  double remaining_development;    ///< resting length at the end of life minus resting_length [m]
  double phase;                    ///< present phase offset of actuation, of a leg that of its swing [cycles]
};

/// One robot at one time.
struct RobotFrame
{
  double time_since_birth = 0.0;                                    ///< [s]
  std::vector<ShownPart> parts;                                     ///< voxels in the order of DevelopmentalProgram
  Eigen::Vector3d center_of_mass = Eigen::Vector3d::Zero();         ///< of the quadruped: of its abdomen [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< mean of the voxels', or the abdomen's, to world

  /// Whether every number is finite; just before a simulation diverges one may not be.
  bool finite() const;
};

/// A robot that is alive: all that looking at it takes of a kind of body. Not thread-safe.
class LivingRobot
{
public:
  virtual ~LivingRobot() = default;

  virtual void step() = 0;  ///< @pre !finished()
  virtual bool finished() const = 0;
  virtual bool diverged() const = 0;
  virtual double timeSinceBirth() const = 0;         ///< [s]; negative before birth
  virtual RobotFrame frame() const = 0;              ///< @pre !diverged()
  virtual Eigen::Vector3d centerOfMass() const = 0;  ///< that of frame() @pre !diverged()
  virtual Evaluation evaluation() const = 0;         ///< over the life so far
};

/// Before birth, or at birth if nothing goes before it. @throw InvalidInput if program or settings are invalid.
std::unique_ptr<LivingRobot> makeLivingRobot(const BodySettings& body, const DevelopmentalProgram& program);

/// Simulates one individual's life and can be looked at on the way. It is the life that evaluations are made of, to
/// the last bit: evaluation() at the end is what Body::evaluate() gives. Costs about 1.5 % of a core in real time for
/// the paper's body; keeps nothing of the past. Not thread-safe.
class LifePlayback
{
public:
  /// As makeLivingRobot().
  LifePlayback(const BodySettings& body, const DevelopmentalProgram& program) : robot_(makeLivingRobot(body, program))
  {
  }

  /// Simulates up to the first step that ends after this time, or to the end of life; 0 is birth.
  /// @param stop if given, looked at every few steps. @throw EvaluationAbandoned once it is true.
  /// @return whether that time was reached; false if life ended, or the simulation diverged, before.
  bool advanceTo(double time_since_birth_s, const std::atomic<bool>* stop = nullptr);

  /// Simulates to the end of life.
  void finish(const std::atomic<bool>* stop = nullptr);

  bool finished() const { return robot_->finished(); }
  bool diverged() const { return robot_->diverged(); }

  /// Time of the present state since birth [s]; negative before birth.
  double time() const { return robot_->timeSinceBirth(); }

  /// The present state. @pre !diverged()
  RobotFrame frame() const { return robot_->frame(); }

  /// That of frame(), in the world frame [m]. @pre !diverged()
  Eigen::Vector3d centerOfMass() const { return robot_->centerOfMass(); }

  /// Measures over the life so far; those of the individual once finished().
  Evaluation evaluation() const { return robot_->evaluation(); }

private:
  const std::unique_ptr<LivingRobot> robot_;
};
}  // namespace devo_evo
