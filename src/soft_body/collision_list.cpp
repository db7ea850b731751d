#include "collision_list.h"

#include <algorithm>
#include <cmath>

namespace devo_evo
{
namespace
{
constexpr int MINIMUM_LATTICE_DISTANCE = 4;  // face-steps: bonds keep nearer ones apart
constexpr double MOTION_LIMIT = 0.5;         // in voxel sizes
constexpr double HORIZON = 3.0;              // in voxel sizes

double field(const double* voxels, int lanes, int voxel, int offset, int robot)
{
  return voxels[(voxel * VOXEL_FIELDS + offset) * lanes + robot];
}
}  // namespace

CollisionList::CollisionList(const Lattice& lattice, double voxel_size, int lanes, int robots)
  : voxel_size_(voxel_size), lanes_(lanes), motion_(static_cast<size_t>(robots), 0.0)
{
  const std::vector<int>& surface = lattice.surface();
  for (size_t i = 0; i < surface.size(); ++i)
  {
    for (size_t j = i + 1; j < surface.size(); ++j)
    {
      if (lattice.manhattanDistance(surface[i], surface[j]) >= MINIMUM_LATTICE_DISTANCE)
      {
        candidates_.push_back({ surface[i], surface[j], 0 });
      }
    }
  }
}

void CollisionList::update(const double* voxels, const double* max_speed_squared, double dt)
{
  bool changed = false;
  for (size_t robot = 0; robot < motion_.size(); ++robot)
  {
    motion_[robot] += std::sqrt(max_speed_squared[robot]) * dt / voxel_size_;
    if (!listed_before_ || motion_[robot] > MOTION_LIMIT)
    {
      list(voxels, static_cast<int>(robot));
      motion_[robot] = 0.0;
      changed = true;
    }
  }
  listed_before_ = true;
  if (changed)
  {
    pairs_.clear();
    std::copy_if(candidates_.begin(), candidates_.end(), std::back_inserter(pairs_),
                 [](const CollisionPair& pair) { return pair.robots != 0; });
  }
}

void CollisionList::list(const double* voxels, int robot)
{
  const uint32_t bit = 1u << robot;
  for (CollisionPair& pair : candidates_)
  {
    double square = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double apart = field(voxels, lanes_, pair.voxel_b, POSITION + axis, robot) -
                           field(voxels, lanes_, pair.voxel_a, POSITION + axis, robot);
      square += apart * apart;
    }
    const double reach = std::min(HORIZON * voxel_size_, 2.0 * field(voxels, lanes_, pair.voxel_a, SCALE, robot));
    pair.robots = square < reach * reach ? pair.robots | bit : pair.robots & ~bit;
  }
}
}  // namespace devo_evo
