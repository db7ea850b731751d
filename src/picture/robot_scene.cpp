#include "devo_evo/picture/robot_scene.h"

#include <algorithm>

namespace devo_evo
{
ColouredTriangles robotTriangles(const RobotMesh& mesh, const RobotFrame& frame, Colouring colouring, double voxel_size)
{
  const std::vector<Eigen::Vector3d> vertices = mesh.vertices(frame);
  ColouredTriangles triangles;
  triangles.corners.reserve(6 * mesh.faces().size());
  triangles.colours.reserve(6 * mesh.faces().size());
  for (const RobotMesh::Face& face : mesh.faces())
  {
    const Colour colour = colourOf(frame.voxels[static_cast<size_t>(face.voxel)], colouring, voxel_size);
    for (const size_t corner : { 0, 1, 2, 0, 2, 3 })
    {
      triangles.corners.push_back(vertices[static_cast<size_t>(face.corners[corner])].cast<float>());
      triangles.colours.emplace_back(colour.red, colour.green, colour.blue);
    }
  }
  return triangles;
}

double bodySize(const SoftBodySettings& settings)
{
  return settings.voxel_size * std::max({ settings.grid_x, settings.grid_y, settings.grid_z });
}

double bodyLength(const SoftBodySettings& settings)
{
  return settings.voxel_size * settings.grid_y;
}

FollowingPoint::FollowingPoint(double interval, double time_constant) : share_(interval / (interval + time_constant))
{
}

Eigen::Vector3d FollowingPoint::follow(const Eigen::Vector3d& point)
{
  if (!started_)
  {
    started_ = true;
    once_ = twice_ = point;
  }
  once_ += share_ * (point - once_);
  twice_ += share_ * (once_ - twice_);
  return 2.0 * once_ - twice_;
}
}  // namespace devo_evo
