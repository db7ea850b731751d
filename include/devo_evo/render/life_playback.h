#pragma once

#include "devo_evo/soft_body/developmental_program.h"
#include "devo_evo/soft_body/evaluation.h"
#include "devo_evo/soft_body/settings.h"
#include "devo_evo/soft_body/simulation.h"

#include <Eigen/Geometry>

#include <atomic>
#include <memory>
#include <vector>

namespace devo_evo
{
/// One voxel as it is shown. World frame: right-handed, z up, floor at z = 0.
struct ShownVoxel
{
  Eigen::Vector3d position;        ///< centre [m]
  Eigen::Quaterniond orientation;  ///< body to world
  double present_length;           ///< edge length with actuation [m]
  double resting_length;           ///< edge length that it would have now without actuation [m]
  double remaining_development;    ///< resting length at the end of life minus resting_length [m]
  double phase;                    ///< present phase offset of actuation [cycles]
};

/// One robot at one time.
struct RobotFrame
{
  double time_since_birth = 0.0;                                    ///< [s]
  std::vector<ShownVoxel> voxels;                                   ///< in the order of DevelopmentalProgram
  Eigen::Vector3d center_of_mass = Eigen::Vector3d::Zero();         ///< [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< mean of the voxels', body to world

  /// Whether every number is finite; just before a simulation diverges one may not be.
  bool finite() const;
};

/// Simulates one individual's life and can be looked at on the way. It is the life that evaluations are made of, to
/// the last bit: evaluation() at the end is what evaluate() gives. Costs about 1.5 % of a core in real time for the
/// paper's body; keeps nothing of the past. Not thread-safe.
class LifePlayback
{
public:
  /// Before birth, with the body still to settle. @throw InvalidInput if program or settings are invalid.
  LifePlayback(const SoftBodySettings& settings, const DevelopmentalProgram& program);

  /// Simulates up to the first step that ends after this time, or to the end of life; 0 is birth.
  /// @param stop if given, looked at every few steps. @throw EvaluationAbandoned once it is true.
  /// @return whether that time was reached; false if life ended, or the simulation diverged, before.
  bool advanceTo(double time_since_birth_s, const std::atomic<bool>* stop = nullptr);

  /// Simulates to the end of life.
  void finish(const std::atomic<bool>* stop = nullptr);

  bool finished() const { return simulation_->finished(); }
  bool diverged() const { return simulation_->diverged(0); }

  /// Time of the present state since birth [s]; negative before birth.
  double time() const { return simulation_->time() - SETTLING_TIME; }

  /// The present state. @pre !diverged()
  RobotFrame frame() const;

  /// Mean of the voxels' positions now, in the world frame [m]. @pre !diverged()
  Eigen::Vector3d centerOfMass() const { return simulation_->centerOfMass(0); }

  /// Measures over the life so far; those of the individual once finished().
  Evaluation evaluation() const { return simulation_->evaluation(0); }

  const SoftBodySettings& settings() const { return settings_; }

private:
  const SoftBodySettings settings_;
  const DevelopmentalProgram program_;
  const std::unique_ptr<Simulation> simulation_;
};
}  // namespace devo_evo
