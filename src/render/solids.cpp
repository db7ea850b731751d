#include "render/solids.h"

#include <cmath>

namespace devo_evo
{
namespace
{
constexpr double HALF_TURN = 3.141592653589793;

/// A ring of corners at one height.
struct Ring
{
  double polar;  ///< angle from +z of the normals [rad]
  double shift;  ///< of the half sphere along z [m]
};

std::vector<Ring> ringsOf(double length, int stacks)
{
  std::vector<Ring> rings;
  for (const double end : { 1.0, -1.0 })
  {
    for (int i = 0; i <= stacks; ++i)
    {
      const double from_pole = HALF_TURN / 2 * (end > 0.0 ? i : stacks - i) / stacks;
      rings.push_back({ end > 0.0 ? from_pole : HALF_TURN - from_pole, end * length / 2 });
    }
  }
  if (length == 0.0)  // both equators are the same
  {
    rings.erase(rings.begin() + stacks);
  }
  return rings;
}
}  // namespace

Solid capsule(double radius, double length, int sectors, int stacks)
{
  Solid solid;
  const std::vector<Ring> rings = ringsOf(length, stacks);
  const auto add = [&](const Ring& ring, int meridian)
  {
    const double azimuth = 2 * HALF_TURN * meridian / sectors;
    const Eigen::Vector3d normal(std::sin(ring.polar) * std::cos(azimuth), std::sin(ring.polar) * std::sin(azimuth),
                                 std::cos(ring.polar));
    solid.normals.push_back(normal);
    solid.corners.emplace_back(radius * normal + Eigen::Vector3d(0.0, 0.0, ring.shift));
  };
  for (int sector = 0; sector < sectors; ++sector)
  {
    for (size_t i = 0; i + 1 < rings.size(); ++i)
    {
      const Ring &upper = rings[i], &lower = rings[i + 1];
      if (i + 2 < rings.size())  // else both lower corners are the pole
      {
        add(upper, sector);
        add(lower, sector);
        add(lower, sector + 1);
      }
      if (i > 0)  // else both upper corners are the pole
      {
        add(upper, sector);
        add(lower, sector + 1);
        add(upper, sector + 1);
      }
    }
  }
  return solid;
}
}  // namespace devo_evo
