#pragma once

#include "devo_evo/picture/scene.h"
#include "devo_evo/render/colouring.h"
#include "devo_evo/render/life_playback.h"
#include "devo_evo/render/robot_mesh.h"

#include <Eigen/Core>

namespace devo_evo
{
/// A robot as it is drawn: every visible face of its voxels as two triangles.
ColouredTriangles robotTriangles(const RobotMesh& mesh, const RobotFrame& frame, Colouring colouring,
                                 double voxel_size);

/// Size of a body for cameras and shadows: its longest side [m].
double bodySize(const SoftBodySettings& settings);

/// One body length [m].
double bodyLength(const SoftBodySettings& settings);

/// Follows a moving point smoothly, without falling behind one that moves evenly. A function of what it has been shown
/// so far, at equal intervals.
class FollowingPoint
{
public:
  /// @param interval between calls of follow(). @param time_constant of the smoothing, both in the same unit.
  FollowingPoint(double interval, double time_constant);

  Eigen::Vector3d follow(const Eigen::Vector3d& point);

private:
  const double share_;
  bool started_ = false;
  Eigen::Vector3d once_, twice_;
};
}  // namespace devo_evo
