#include "devo_evo/picture/robot_scene.h"

#include "render/solids.h"

#include <algorithm>

namespace devo_evo
{
namespace
{
const Eigen::Vector3f LAMP(1.0f, 0.80f, 0.15f);
const Eigen::Vector3f POST(0.45f, 0.44f, 0.42f);

/// A solid that stands upright.
ColouredTriangles standing(const Solid& solid, const Eigen::Vector3d& place, const Eigen::Vector3f& colour)
{
  ColouredTriangles triangles;
  for (size_t i = 0; i < solid.corners.size(); ++i)
  {
    triangles.corners.emplace_back((place + solid.corners[i]).cast<float>());
    triangles.normals.emplace_back(solid.normals[i].cast<float>());
  }
  triangles.colours.assign(solid.corners.size(), colour);
  return triangles;
}
}  // namespace

std::vector<ColouredTriangles> robotTriangles(const Appearance& appearance, const RobotFrame& frame,
                                              Colouring colouring)
{
  const Eigen::Matrix3d to_floor = appearance.surroundings().floorToWorld().conjugate().toRotationMatrix();
  std::vector<ColouredTriangles> robot;
  for (const Surface& surface : appearance.surfaces(frame, colouring))
  {
    ColouredTriangles triangles;
    for (size_t i = 0; i < surface.corners.size(); ++i)
    {
      const Colour& colour = surface.colours[i];
      triangles.corners.emplace_back((to_floor * surface.corners[i]).cast<float>());
      triangles.colours.emplace_back(colour.red, colour.green, colour.blue);
      if (!surface.flat)
      {
        triangles.normals.emplace_back((to_floor * surface.normals[i]).cast<float>());
      }
    }
    robot.push_back(std::move(triangles));
  }
  return robot;
}

std::vector<ColouredTriangles> lightTriangles(const Surroundings& surroundings)
{
  if (!surroundings.light)
  {
    return {};
  }
  const Eigen::Vector3d lamp = surroundings.onFloor(*surroundings.light);
  const double radius = 0.3 * surroundings.body_size, thickness = 0.05 * surroundings.body_size;
  const Eigen::Vector3d middle_of_post(lamp.x(), lamp.y(), lamp.z() / 2);
  return { standing(capsule(radius, 0.0, 24, 6), lamp, LAMP),
           standing(capsule(thickness, std::max(lamp.z() - 2 * thickness, 0.0), 10, 1), middle_of_post, POST) };
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
