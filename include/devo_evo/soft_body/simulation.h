#pragma once

#include "devo_evo/soft_body/developmental_program.h"
#include "devo_evo/soft_body/evaluation.h"
#include "devo_evo/soft_body/settings.h"

#include <Eigen/Geometry>

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace devo_evo
{
/// Instruction sets that the kernel is compiled for. Results are the same to the last bit in each.
enum class InstructionSet
{
  SCALAR,  ///< one robot at a time, on any processor
  AVX2,    ///< four robots at a time
  AVX512   ///< eight robots at a time
};

/// Whether this program holds a kernel for it and this processor can run it.
bool isSupported(InstructionSet instruction_set);

/// The fastest supported one.
InstructionSet bestInstructionSet();

/// "scalar", "avx2" or "avx512".
std::string toString(InstructionSet instruction_set);

/// @param name one of the names above, or "auto" for bestInstructionSet().
/// @throw InvalidInput if the name is unknown or the processor cannot run it.
InstructionSet parseInstructionSet(const std::string& name);

/// How many robots its kernel simulates in lock-step: 1, 4 or 8.
int laneCount(InstructionSet instruction_set);

/// One voxel at the end of the last completed step. World frame: right-handed, z up, floor at z = 0; body frame: the
/// voxel's.
struct VoxelState
{
  Eigen::Vector3d position;          ///< centre [m]
  Eigen::Quaterniond orientation;    ///< body to world
  Eigen::Vector3d velocity;          ///< [m/s]
  Eigen::Vector3d angular_velocity;  ///< in world frame [rad/s]
  double scale;                      ///< present resting edge length, actuation included [m]
  bool static_friction;              ///< whether the floor holds it
};

/// Up to laneCount() robots living their lives in lock-step, one robot a lane. Robots do not influence each other.
/// Not thread-safe; different simulations are independent.
class Simulation
{
public:
  virtual ~Simulation() = default;

  /// Number of robots, fixed at construction.
  virtual int robotCount() const = 0;

  /// Advances every robot by one time step. @pre !finished()
  virtual void step() = 0;

  /// Whether the lifetime is over, or every robot has diverged.
  virtual bool finished() const = 0;

  /// Steps completed, and the simulator time after them (birth at SETTLING_TIME) [s].
  virtual int64_t stepCount() const = 0;
  virtual double time() const = 0;

  /// Whether the robot's simulation has diverged; its states have no meaning then.
  virtual bool diverged(int robot) const = 0;

  /// @param voxel index as in DevelopmentalProgram.
  virtual VoxelState voxel(int robot, int voxel) const = 0;

  /// Mean of the voxels' positions, in the world frame [m].
  virtual Eigen::Vector3d centerOfMass(int robot) const = 0;

  /// Normalised mean of the voxels' orientations, body to world.
  virtual Eigen::Quaterniond meanOrientation(int robot) const = 0;

  /// Resting length without actuation that the voxel has now [m] (paper, Eq. 1).
  virtual double restingLength(int robot, int voxel) const = 0;

  /// Results over the life so far; those of Evaluation once finished().
  virtual Evaluation evaluation(int robot) const = 0;
};

/// @param programs one to laneCount(instruction_set) robots.
/// @throw InvalidInput if a program or the settings are invalid.
std::unique_ptr<Simulation> makeSimulation(const SoftBodySettings& settings,
                                           const std::vector<DevelopmentalProgram>& programs,
                                           InstructionSet instruction_set = bestInstructionSet());

/// Thrown by evaluate() when it was told to stop.
class EvaluationAbandoned : public std::runtime_error
{
public:
  EvaluationAbandoned() : std::runtime_error("the evaluation was abandoned before its end") {}
};

/// Simulates whole lives, in lock-step groups of laneCount(), on the calling thread.
/// @param stop if given, checked about every ten milliseconds; once true, EvaluationAbandoned is thrown.
/// @return one evaluation per program, in their order.
/// @throw InvalidInput if a program or the settings are invalid.
std::vector<Evaluation> evaluate(const SoftBodySettings& settings, const std::vector<DevelopmentalProgram>& programs,
                                 InstructionSet instruction_set = bestInstructionSet(),
                                 const std::atomic<bool>* stop = nullptr);

/// Hash of the evaluations of a fixed set of robots with default settings: equal for equal engines.
uint64_t engineFingerprint(InstructionSet instruction_set = bestInstructionSet());
}  // namespace devo_evo
