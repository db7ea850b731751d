#include "devo_evo/picture/scene.h"

#include <Eigen/Geometry>

#include <cmath>

namespace devo_evo
{
namespace
{
/// @return the scene's frame to the camera's.
Eigen::Matrix4d viewOf(const Camera& camera)
{
  const Eigen::Matrix3d to_level = Eigen::AngleAxisd(-camera.slope, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const Eigen::Vector3d backwards(std::cos(camera.elevation) * std::cos(camera.azimuth),
                                  std::cos(camera.elevation) * std::sin(camera.azimuth), std::sin(camera.elevation));
  const Eigen::Vector3d right(-std::sin(camera.azimuth), std::cos(camera.azimuth), 0.0);
  const Eigen::Vector3d eye = to_level * camera.target + camera.distance * backwards;
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
  view.block<1, 3>(0, 0) = right;
  view.block<1, 3>(1, 0) = backwards.cross(right);
  view.block<1, 3>(2, 0) = backwards;
  view.block<3, 1>(0, 3) = -view.block<3, 3>(0, 0) * eye;
  view.block<3, 3>(0, 0) *= to_level;
  return view;
}
}  // namespace

Eigen::Matrix4d Camera::projection(double aspect_ratio) const
{
  const double near = 0.05 * distance, far = 50.0 * distance;
  Eigen::Matrix4d lens = Eigen::Matrix4d::Zero();
  if (field_of_view > 0.0)
  {
    const double focal = 1.0 / std::tan(field_of_view / 2);
    lens(0, 0) = focal / aspect_ratio;
    lens(1, 1) = focal;
    lens(2, 2) = (far + near) / (near - far);
    lens(2, 3) = 2 * far * near / (near - far);
    lens(3, 2) = -1.0;
  }
  else
  {
    lens(0, 0) = 2.0 / (height * aspect_ratio);
    lens(1, 1) = 2.0 / height;
    lens(2, 2) = 2.0 / (near - far);
    lens(2, 3) = (far + near) / (near - far);
    lens(3, 3) = 1.0;
  }
  return lens * viewOf(*this);
}

Eigen::Vector2d Camera::toPicture(const Eigen::Vector3d& point, int width, int height_in_pixels) const
{
  const Eigen::Vector4d clip =
      projection(static_cast<double>(width) / height_in_pixels) * Eigen::Vector4d(point.x(), point.y(), point.z(), 1.0);
  return { width * (0.5 + 0.5 * clip.x() / clip.w()), height_in_pixels * (0.5 - 0.5 * clip.y() / clip.w()) };
}
}  // namespace devo_evo
