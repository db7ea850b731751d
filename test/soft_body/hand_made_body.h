#pragma once

#include "devo_evo/soft_body/lattice.h"
#include "devo_evo/soft_body/settings.h"

#include "soft_body/batch_memory.h"
#include "soft_body/body_model.h"
#include "soft_body/collision_list.h"
#include "soft_body/kernel.h"

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace devo_evo
{
/// A body whose state is set by hand and advanced by a kernel, for comparing its forces with pen-and-paper values.
/// It starts as every robot does: at rest on its lattice places, unrotated, at nominal size. Voxels keep the resting
/// length they are given; nothing actuates them unless `clock` says so. Lane 0 is meant where no other is named.
class HandMadeBody
{
public:
  explicit HandMadeBody(const SoftBodySettings& settings, const Kernel& kernel = *scalarKernel())
    : kernel_(kernel)
    , lattice_(settings)
    , constants_(settings, lattice_)
    , memory_(constants_.model(), kernel.lanes)
    , collisions_(lattice_, settings.voxel_size, kernel.lanes, 1)
  {
    memory_.lendTo(state_);
    for (int lane = 0; lane < kernel_.lanes; ++lane)
    {
      for (int voxel = 0; voxel < lattice_.voxelCount(); ++voxel)
      {
        const std::array<int, 3> place = lattice_.coordinates(voxel);
        const Eigen::Vector3d cell(place[0], place[1], place[2]);
        setPosition(voxel, settings.voxel_size * (cell + Eigen::Vector3d::Constant(0.5)), lane);
        setOrientation(voxel, Eigen::Quaterniond::Identity(), lane);
        setScale(voxel, settings.voxel_size, lane);
      }
    }
  }
  HandMadeBody(const HandMadeBody&) = delete;
  HandMadeBody& operator=(const HandMadeBody&) = delete;

  /// What the next steps are told; its default is a body that has grown but not yet begun to move.
  StepClock clock = { false, false, 1.0, 0.0, 0.0 };

  const BodyModel& model() const { return constants_.model(); }
  const Lattice& lattice() const { return lattice_; }
  BatchState& state() { return state_; }

  double& at(int voxel, int field, int lane = 0)
  {
    return state_.voxels[(voxel * VOXEL_FIELDS + field) * kernel_.lanes + lane];
  }
  Eigen::Vector3d vectorAt(int voxel, int field, int lane = 0)
  {
    return { at(voxel, field, lane), at(voxel, field + 1, lane), at(voxel, field + 2, lane) };
  }
  void setVectorAt(int voxel, int field, const Eigen::Vector3d& value, int lane = 0)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      at(voxel, field + axis, lane) = value[axis];
    }
  }

  Eigen::Vector3d position(int voxel) { return vectorAt(voxel, POSITION); }
  Eigen::Vector3d velocity(int voxel) { return model().inverse_mass * vectorAt(voxel, MOMENTUM); }
  void setPosition(int voxel, const Eigen::Vector3d& position, int lane = 0)
  {
    setVectorAt(voxel, POSITION, position, lane);
  }
  void setVelocity(int voxel, const Eigen::Vector3d& velocity, int lane = 0)
  {
    setVectorAt(voxel, MOMENTUM, velocity / model().inverse_mass, lane);
  }
  void setOrientation(int voxel, const Eigen::Quaterniond& q, int lane = 0)
  {
    at(voxel, ORIENTATION, lane) = q.w();
    setVectorAt(voxel, ORIENTATION + 1, q.vec(), lane);
  }

  /// Resting length, now and (unless the clock says otherwise) from now on.
  void setScale(int voxel, double scale, int lane = 0)
  {
    at(voxel, SCALE, lane) = scale;
    at(voxel, SIZE_AT_BIRTH, lane) = scale;
  }

  bool smallAngle(int bond, int lane = 0) const
  {
    return (memory_.small_angle[static_cast<size_t>(bond)] >> lane & 1) != 0;
  }
  void setSmallAngle(int bond, bool small_angle)
  {
    memory_.small_angle[static_cast<size_t>(bond)] = small_angle ? 1 : 0;
  }
  bool staticFriction(int voxel, int lane = 0) const
  {
    return (memory_.static_friction[static_cast<size_t>(voxel)] >> lane & 1) != 0;
  }

  /// Lists the pairs that may collide, as every simulation does before a step.
  void listCollisions()
  {
    collisions_.update(state_.voxels, state_.max_speed_squared, model().dt);
    state_.collision_pairs = collisions_.pairs().data();
    state_.collision_pair_count = static_cast<int>(collisions_.pairs().size());
  }

  void step() { kernel_.step(model(), clock, state_); }

  /// What acted on the voxels in one step from the present state, as the changes of their momenta show. The step moves
  /// the voxels; momenta are set to zero before it, so that nothing depends on speed.
  struct Loads
  {
    std::vector<Eigen::Vector3d> forces;   ///< [N]
    std::vector<Eigen::Vector3d> moments;  ///< [N m]; right only without global damping, which acts on them too
  };
  Loads loadsOfStep()
  {
    for (int voxel = 0; voxel < lattice_.voxelCount(); ++voxel)
    {
      setVectorAt(voxel, MOMENTUM, Eigen::Vector3d::Zero());
      setVectorAt(voxel, ANGULAR_MOMENTUM, Eigen::Vector3d::Zero());
    }
    step();
    Loads loads;
    for (int voxel = 0; voxel < lattice_.voxelCount(); ++voxel)
    {
      loads.forces.push_back(vectorAt(voxel, MOMENTUM) / model().dt);
      loads.moments.push_back(vectorAt(voxel, ANGULAR_MOMENTUM) / model().dt);
    }
    return loads;
  }

private:
  const Kernel& kernel_;
  const Lattice lattice_;
  const BodyConstants constants_;
  BatchMemory memory_;
  CollisionList collisions_;
  BatchState state_{};
};

/// No gravity and no damping but that of bonds: what is left is bonds, collisions and the floor.
inline SoftBodySettings weightlessSettings(int grid_x, int grid_y, int grid_z)
{
  SoftBodySettings settings;
  settings.grid_x = grid_x;
  settings.grid_y = grid_y;
  settings.grid_z = grid_z;
  settings.gravity = 0.0;
  settings.global_damping = 0.0;
  return settings;
}
}  // namespace devo_evo
