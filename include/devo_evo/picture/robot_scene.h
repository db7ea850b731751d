#pragma once

#include "devo_evo/picture/scene.h"
#include "devo_evo/render/appearance.h"

#include <Eigen/Core>

#include <vector>

namespace devo_evo
{
/// A robot as it is drawn, in the frame that lies on its floor.
std::vector<ColouredTriangles> robotTriangles(const Appearance& appearance, const RobotFrame& frame,
                                              Colouring colouring);

/// A lamp on a post, where the light is; nothing if there is none.
std::vector<ColouredTriangles> lightTriangles(const Surroundings& surroundings);

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
