#include "render/solids.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

namespace devo_evo
{
namespace
{
constexpr double PI = 3.141592653589793;

/// By the divergence theorem; negative if the surface is inside out, wrong if it is not closed.
double volumeOf(const Solid& solid)
{
  double volume = 0.0;
  for (size_t i = 0; i < solid.corners.size(); i += 3)
  {
    volume += solid.corners[i].dot(solid.corners[i + 1].cross(solid.corners[i + 2])) / 6.0;
  }
  return volume;
}

TEST(Capsule, OfNoLengthIsASphere)
{
  const Solid solid = capsule(2.0, 0.0, 40, 20);
  for (size_t i = 0; i < solid.corners.size(); ++i)
  {
    EXPECT_NEAR(solid.corners[i].norm(), 2.0, 1e-12);
    EXPECT_NEAR((solid.corners[i] - 2.0 * solid.normals[i]).norm(), 0.0, 1e-12);
  }
  EXPECT_NEAR(volumeOf(solid), 4.0 / 3.0 * PI * 8.0, 0.01 * 4.0 / 3.0 * PI * 8.0);
}

TEST(Capsule, IsACylinderBetweenTwoHalfSpheres)
{
  const Solid solid = capsule(0.5, 3.0, 40, 20);
  double lowest = 0.0, highest = 0.0;
  for (const Eigen::Vector3d& corner : solid.corners)
  {
    lowest = std::min(lowest, corner.z());
    highest = std::max(highest, corner.z());
    const double beyond = std::max(0.0, std::abs(corner.z()) - 1.5);  // the cylinder's end
    EXPECT_NEAR(std::hypot(corner.head<2>().norm(), beyond), 0.5, 1e-12);
  }
  EXPECT_NEAR(lowest, -2.0, 1e-12);
  EXPECT_NEAR(highest, 2.0, 1e-12);
  const double volume = PI * 0.25 * 3.0 + 4.0 / 3.0 * PI * 0.125;
  EXPECT_NEAR(volumeOf(solid), volume, 0.01 * volume);
}

TEST(Capsule, HasAsManyTrianglesInEverySector)
{
  const int sectors = 7, stacks = 3;
  const Solid solid = capsule(1.0, 1.0, sectors, stacks);
  ASSERT_EQ(solid.corners.size() % (3 * sectors), 0u);
  const size_t in_sector = solid.corners.size() / sectors;
  for (size_t i = 0; i < solid.corners.size(); i += 3)
  {
    const Eigen::Vector3d middle = solid.corners[i] + solid.corners[i + 1] + solid.corners[i + 2];
    const double azimuth = std::atan2(middle.y(), middle.x());
    const double turns = (azimuth < 0.0 ? azimuth + 2 * PI : azimuth) / (2 * PI);
    EXPECT_EQ(static_cast<size_t>(turns * sectors), i / in_sector);
  }
}
}  // namespace
}  // namespace devo_evo
