#pragma once

#include "devo_evo/render/appearance.h"
#include "devo_evo/render/scene.h"

#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

namespace devo_evo
{
/// Frame of all markers: right-handed, z up, metres; robots travel along +y. The floor passes through the origin.
extern const char* const WORLD_FRAME;

/// Draws a robot and its surroundings as markers, a few messages for everything. Namespaces of the markers:
///   body      triangles, shaded: a marker for each of Appearance::surfaces(), its id the place of the surface there.
///   Of
///             a soft body it is one, with two triangles a face of RobotMesh, in the colour of their voxel
///   edges     lines along the edges of flat faces
///   parts     points, one for each of RobotFrame::parts in their order: its centre, in its colour
///   path, velocity, caption
///   floor     its area; `lines`, `marked_lines` and `labels` on it
///   light     a ball where the light is, and its `post`, if there is one
/// Stamps are left 0. Positions are rounded to 2^-17 m (0.008 mm), so that bags of them can be compressed.
class SceneMarkers
{
public:
  /// @param offset added to every position [m].
  SceneMarkers(const BodySettings& body, const Eigen::Vector3d& offset);

  /// Namespaces body, edges and parts.
  visualization_msgs::MarkerArray robot(const RobotFrame& frame, Colouring colouring) const;

  /// Namespaces path, velocity and caption. @param trace in the world frame. The arrow, above the robot, is as long as
  /// the way in ARROW_TIME at that velocity.
  visualization_msgs::MarkerArray annotations(const RobotFrame& frame, const MotionTrace& trace,
                                              const std::string& caption) const;

  /// Namespaces floor, lines, marked_lines, labels, light and post.
  visualization_msgs::MarkerArray floor(const FloorPlan& plan) const;

  static constexpr double ARROW_TIME = 1.0;  ///< [s]

private:
  visualization_msgs::MarkerArray light() const;
  visualization_msgs::Marker marker(const std::string& name_space, int32_t type) const;
  geometry_msgs::Point point(const Eigen::Vector3d& position) const;

  const std::shared_ptr<const Appearance> appearance_;
  const Surroundings surroundings_;
  const Eigen::Vector3d offset_;
};

/// Takes away everything that was drawn.
visualization_msgs::MarkerArray nothing();

void setStamp(visualization_msgs::MarkerArray& markers, const ros::Time& stamp);

/// Appends the markers of one array to another.
void append(visualization_msgs::MarkerArray& markers, visualization_msgs::MarkerArray more);
}  // namespace devo_evo
