#pragma once

#include <Eigen/Core>

#include <vector>

namespace devo_evo
{
/// A closed, smooth surface of triangles around the origin, its own axis along z.
struct Solid
{
  std::vector<Eigen::Vector3d> corners;  ///< three per triangle, counter-clockwise as seen from outside [m]
  std::vector<Eigen::Vector3d> normals;  ///< of each corner, outwards, of length 1
};

/// A cylinder between two half spheres; a sphere, if its length is 0. Corners lie on the true surface.
/// @param length of the cylinder [m]. @param sectors around the axis, 3 or more. @param stacks of each half sphere, 1
/// or more. Triangles come sector by sector, counted counter-clockwise from +x as seen from +z, as many in each.
Solid capsule(double radius, double length, int sectors, int stacks);
}  // namespace devo_evo
