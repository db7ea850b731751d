#include "collision_list.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace devo_evo
{
namespace
{
constexpr int MINIMUM_LATTICE_DISTANCE = 4;  // face-steps: bonds keep nearer ones apart
constexpr double MOTION_LIMIT = 0.5;         // in voxel sizes
constexpr double HORIZON = 3.0;              // in voxel sizes
constexpr size_t SMALL_BODY = 128;           // surface voxels, up to which testing every pair is cheaper than sorting

bool comesBefore(const CollisionPair& a, const CollisionPair& b)
{
  return a.voxel_a != b.voxel_a ? a.voxel_a < b.voxel_a : a.voxel_b < b.voxel_b;
}

/// The cubes of one horizon's width in which voxels are; only neighbouring ones can hold a close pair.
struct CellEntry
{
  std::array<int64_t, 3> cell;  ///< z, y, x
  int voxel;

  bool operator<(const CellEntry& other) const { return cell < other.cell; }
};

int64_t cellOf(double coordinate, double width)
{
  constexpr double limit = 1e15;  // far outside any world, and safe to convert; NaN goes there too
  const double cell = std::floor(coordinate / width);
  return static_cast<int64_t>(cell > -limit ? std::min(cell, limit) : -limit);
}
}  // namespace

CollisionList::CollisionList(const Lattice& lattice, double voxel_size, int lanes, int robots)
  : lattice_(lattice), voxel_size_(voxel_size), lanes_(lanes), motion_(static_cast<size_t>(robots), 0.0)
{
  const std::vector<int>& surface = lattice_.surface();
  if (surface.size() > SMALL_BODY)
  {
    return;
  }
  for (size_t i = 0; i < surface.size(); ++i)
  {
    for (size_t j = i + 1; j < surface.size(); ++j)
    {
      if (lattice_.manhattanDistance(surface[i], surface[j]) >= MINIMUM_LATTICE_DISTANCE)
      {
        candidates_.push_back({ surface[i], surface[j], 0 });
      }
    }
  }
}

void CollisionList::update(const double* voxels, const double* max_speed_squared, double dt)
{
  for (size_t robot = 0; robot < motion_.size(); ++robot)
  {
    motion_[robot] += std::sqrt(max_speed_squared[robot]) * dt / voxel_size_;
    if (!listed_before_ || motion_[robot] > MOTION_LIMIT)
    {
      list({ voxels, lanes_, static_cast<int>(robot) });
      motion_[robot] = 0.0;
    }
  }
  listed_before_ = true;
}

bool CollisionList::isClose(const Body& body, int voxel_a, int voxel_b) const
{
  double square = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double apart = body.at(voxel_b, POSITION + axis) - body.at(voxel_a, POSITION + axis);
    square += apart * apart;
  }
  const double reach = std::min(HORIZON * voxel_size_, 2.0 * body.at(voxel_a, SCALE));
  return square < reach * reach;
}

void CollisionList::findAmongCandidates(const Body& body)
{
  for (const CollisionPair& pair : candidates_)
  {
    if (isClose(body, pair.voxel_a, pair.voxel_b))
    {
      found_.push_back(pair);
    }
  }
}

void CollisionList::findByCells(const Body& body)
{
  const double width = HORIZON * voxel_size_;
  std::vector<CellEntry> entries;
  for (const int voxel : lattice_.surface())
  {
    entries.push_back({ { cellOf(body.at(voxel, POSITION + 2), width), cellOf(body.at(voxel, POSITION + 1), width),
                          cellOf(body.at(voxel, POSITION), width) },
                        voxel });
  }
  std::sort(entries.begin(), entries.end());
  for (const CellEntry& entry : entries)
  {
    const auto [z, y, x] = entry.cell;
    for (const int64_t near_z : { z - 1, z, z + 1 })
    {
      for (const int64_t near_y : { y - 1, y, y + 1 })
      {
        const CellEntry first = { { near_z, near_y, x - 1 }, 0 };
        const CellEntry last = { { near_z, near_y, x + 1 }, 0 };
        const auto end = std::upper_bound(entries.begin(), entries.end(), last);
        for (auto other = std::lower_bound(entries.begin(), entries.end(), first); other != end; ++other)
        {
          if (entry.voxel < other->voxel &&
              lattice_.manhattanDistance(entry.voxel, other->voxel) >= MINIMUM_LATTICE_DISTANCE &&
              isClose(body, entry.voxel, other->voxel))
          {
            found_.push_back({ entry.voxel, other->voxel, 0 });
          }
        }
      }
    }
  }
  std::sort(found_.begin(), found_.end(), comesBefore);
}

void CollisionList::list(const Body& body)
{
  found_.clear();
  if (lattice_.surface().size() > SMALL_BODY)
  {
    findByCells(body);
  }
  else
  {
    findAmongCandidates(body);
  }

  // Replace this robot's pairs in the common list
  const uint32_t bit = 1u << body.robot;
  merged_.clear();
  auto found = found_.begin();
  for (CollisionPair& pair : pairs_)
  {
    for (; found != found_.end() && comesBefore(*found, pair); ++found)
    {
      merged_.push_back({ found->voxel_a, found->voxel_b, bit });
    }
    pair.robots &= ~bit;
    if (found != found_.end() && !comesBefore(pair, *found))
    {
      pair.robots |= bit;
      ++found;
    }
    if (pair.robots != 0)
    {
      merged_.push_back(pair);
    }
  }
  for (; found != found_.end(); ++found)
  {
    merged_.push_back({ found->voxel_a, found->voxel_b, bit });
  }
  pairs_.swap(merged_);
}
}  // namespace devo_evo
