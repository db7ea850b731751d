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

inline bool CollisionList::isClose(const Place& a, const Place& b)
{
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
    if (isClose(places_[static_cast<size_t>(pair.voxel_a)], places_[static_cast<size_t>(pair.voxel_b)]))
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
  std::vector<Place> in_order;  // so that what is compared lies together
  for (const CellEntry& entry : entries)
  {
    in_order.push_back(places_[static_cast<size_t>(entry.voxel)]);
  }
  const auto list_close = [&](size_t entry, size_t first, size_t last)
  {
    const int voxel = entries[entry].voxel;
    for (size_t other = first; other < last; ++other)
    {
      const int other_voxel = entries[other].voxel;
      const bool is_first = voxel < other_voxel;
      if (isClose(in_order[is_first ? entry : other], in_order[is_first ? other : entry]) &&
          lattice_.manhattanDistance(voxel, other_voxel) >= MINIMUM_LATTICE_DISTANCE)
      {
        found_.push_back({ std::min(voxel, other_voxel), std::max(voxel, other_voxel), 0 });
      }
    }
  };
  // Each pair is met once: from the cell that comes first. Entries of one cell share their neighbours.
  size_t cell_end = 0;
  for (size_t cell_begin = 0; cell_begin < entries.size(); cell_begin = cell_end)
  {
    const auto [z, y, x] = entries[cell_begin].cell;
    const auto before = [&](int64_t row_z, int64_t row_y, int64_t cell_x)
    {
      const auto begin = entries.begin() + static_cast<std::ptrdiff_t>(cell_begin);
      const CellEntry sought = { { row_z, row_y, cell_x }, -1 };
      return static_cast<size_t>(std::lower_bound(begin, entries.end(), sought) - entries.begin());
    };
    cell_end = before(z, y, x + 1);
    const size_t next_end = before(z, y, x + 2);
    for (size_t entry = cell_begin; entry < cell_end; ++entry)
    {
      list_close(entry, entry + 1, next_end);
    }
    for (const auto& [row_z, row_y] : { std::pair(z, y + 1), { z + 1, y - 1 }, { z + 1, y }, { z + 1, y + 1 } })
    {
      const size_t first = before(row_z, row_y, x - 1);
      const size_t last = before(row_z, row_y, x + 2);
      for (size_t entry = cell_begin; entry < cell_end; ++entry)
      {
        list_close(entry, first, last);
      }
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
