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
  : lattice_(lattice)
  , voxel_size_(voxel_size)
  , lanes_(lanes)
  , motion_(static_cast<size_t>(robots), 0.0)
  , places_(static_cast<size_t>(lattice.voxelCount()))
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

void CollisionList::readPlaces(const Body& body)
{
  for (const int voxel : lattice_.surface())
  {
    const double reach = std::min(HORIZON * voxel_size_, 2.0 * body.at(voxel, SCALE));
    places_[static_cast<size_t>(voxel)] = {
      { body.at(voxel, POSITION), body.at(voxel, POSITION + 1), body.at(voxel, POSITION + 2) }, reach * reach
    };
  }
}

inline bool CollisionList::isClose(int voxel_a, int voxel_b) const
{
  const Place& a = places_[static_cast<size_t>(voxel_a)];
  const Place& b = places_[static_cast<size_t>(voxel_b)];
  double square = 0.0;
  for (size_t axis = 0; axis < 3; ++axis)
  {
    const double apart = b.position[axis] - a.position[axis];
    square += apart * apart;
  }
  return square < a.reach_square;
}

void CollisionList::findAmongCandidates()
{
  for (const CollisionPair& pair : candidates_)
  {
    if (isClose(pair.voxel_a, pair.voxel_b))
    {
      found_.push_back(pair);
    }
  }
}

void CollisionList::findByCells()
{
  const double width = HORIZON * voxel_size_;
  std::vector<CellEntry> entries;
  for (const int voxel : lattice_.surface())
  {
    const auto [x, y, z] = places_[static_cast<size_t>(voxel)].position;
    entries.push_back({ { cellOf(z, width), cellOf(y, width), cellOf(x, width) }, voxel });
  }
  std::sort(entries.begin(), entries.end());
  const auto list_close = [this](const CellEntry& entry, auto first, auto last)
  {
    for (auto other = first; other != last; ++other)
    {
      const auto [a, b] = std::minmax(entry.voxel, other->voxel);
      if (isClose(a, b) && lattice_.manhattanDistance(a, b) >= MINIMUM_LATTICE_DISTANCE)
      {
        found_.push_back({ a, b, 0 });
      }
    }
  };
  for (auto entry = entries.begin(); entry != entries.end(); ++entry)
  {
    // Each pair is met once: from the cell that comes first
    const auto [z, y, x] = entry->cell;
    list_close(*entry, entry + 1, std::upper_bound(entry, entries.end(), CellEntry{ { z, y, x + 1 }, 0 }));
    for (const auto& [row_z, row_y] : { std::pair(z, y + 1), { z + 1, y - 1 }, { z + 1, y }, { z + 1, y + 1 } })
    {
      const auto first = std::lower_bound(entry, entries.end(), CellEntry{ { row_z, row_y, x - 1 }, 0 });
      list_close(*entry, first, std::upper_bound(first, entries.end(), CellEntry{ { row_z, row_y, x + 1 }, 0 }));
    }
  }
  std::sort(found_.begin(), found_.end(), comesBefore);
}

void CollisionList::list(const Body& body)
{
  found_.clear();
  readPlaces(body);
  if (lattice_.surface().size() > SMALL_BODY)
  {
    findByCells();
  }
  else
  {
    findAmongCandidates();
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
