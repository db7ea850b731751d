#include "collision_list.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace devo_evo
{
namespace
{
constexpr int MINIMUM_LATTICE_DISTANCE = 4;  // face-steps: bonds keep nearer ones apart
constexpr double MOTION_LIMIT = 0.5;         // between two listings, in voxel sizes
constexpr double LOOK_LIMIT = 0.2;           // motion between two looks at the listed pairs, in voxel sizes
constexpr double HORIZON = 3.0;              // in voxel sizes
constexpr double REACH = 0.75;               // in sums of both scales: voxels nearer than that push each other apart
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

double squaredDistance(const double* a, const double* b, int stride)
{
  double square = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double apart = b[axis * stride] - a[axis * stride];
    square += apart * apart;
  }
  return square;
}

int64_t cellOf(double coordinate, double width)
{
  constexpr double limit = 1e15;  // far outside any world, and safe to convert; NaN goes there too
  const double cell = std::floor(coordinate / width);
  return static_cast<int64_t>(cell > -limit ? std::min(cell, limit) : -limit);
}
}  // namespace

CollisionList::CollisionList(const Lattice& lattice, double voxel_size, double longest_stroke, int lanes, int robots)
  : lattice_(lattice)
  , voxel_size_(voxel_size)
  , longest_stroke_(longest_stroke)
  , lanes_(lanes)
  , robots_(static_cast<size_t>(robots))
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
  for (size_t i = 0; i < robots_.size(); ++i)
  {
    RobotPairs& robot = robots_[i];
    const double motion = std::sqrt(max_speed_squared[i]) * dt / voxel_size_;
    robot.motion_since_listing += motion;
    robot.motion_since_look += motion;
    const bool list_anew = !listed_before_ || robot.motion_since_listing > MOTION_LIMIT;
    if (list_anew || robot.motion_since_look > LOOK_LIMIT)
    {
      const Body body = { voxels, lanes_, static_cast<int>(i) };
      if (list_anew)
      {
        list(body, robot.listed);
        robot.motion_since_listing = 0.0;
      }
      replacePairs(body, robot.listed);
      robot.motion_since_look = 0.0;
    }
  }
  listed_before_ = true;
}

/// The model's condition for listing a pair.
bool CollisionList::isClose(const Body& body, int voxel_a, int voxel_b) const
{
  const double reach = std::min(HORIZON * voxel_size_, 2.0 * body.at(voxel_a, SCALE));
  return squaredDistance(body.place(voxel_a), body.place(voxel_b), lanes_) < reach * reach;
}

/// Whether the pair can push before the next look: both may come nearer by LOOK_LIMIT and grow as large as they ever
/// do.
bool CollisionList::canTouchSoon(const Body& body, const CollisionPair& pair) const
{
  const auto largest_scale = [&](int voxel)
  {
    const double at_birth = body.at(voxel, SIZE_AT_BIRTH);
    const double at_end = at_birth + body.at(voxel, SIZE_CHANGE);
    return std::max({ voxel_size_, at_birth, at_end }) + longest_stroke_;
  };
  const double reach = REACH * (largest_scale(pair.voxel_a) + largest_scale(pair.voxel_b));
  const double limit = 1.000001 * (reach + 2.0 * LOOK_LIMIT * voxel_size_);  // with room for rounding
  return squaredDistance(body.place(pair.voxel_a), body.place(pair.voxel_b), lanes_) < limit * limit;
}

void CollisionList::listFromCandidates(const Body& body, std::vector<CollisionPair>& listed) const
{
  for (const CollisionPair& pair : candidates_)
  {
    if (isClose(body, pair.voxel_a, pair.voxel_b))
    {
      listed.push_back(pair);
    }
  }
}

void CollisionList::listByCells(const Body& body, std::vector<CollisionPair>& listed) const
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
            listed.push_back({ entry.voxel, other->voxel, 0 });
          }
        }
      }
    }
  }
  std::sort(listed.begin(), listed.end(), comesBefore);
}

void CollisionList::list(const Body& body, std::vector<CollisionPair>& listed) const
{
  listed.clear();
  if (lattice_.surface().size() > SMALL_BODY)
  {
    listByCells(body, listed);
  }
  else
  {
    listFromCandidates(body, listed);
  }
}

/// Replaces the robot's pairs in the common list.
void CollisionList::replacePairs(const Body& body, const std::vector<CollisionPair>& listed)
{
  const uint32_t bit = 1u << body.robot;
  merged_.clear();
  auto old = pairs_.begin();
  const auto keep_others_before = [&](const CollisionPair* pair)
  {
    for (; old != pairs_.end() && (pair == nullptr || comesBefore(*old, *pair)); ++old)
    {
      if ((old->robots & ~bit) != 0)
      {
        merged_.push_back({ old->voxel_a, old->voxel_b, old->robots & ~bit });
      }
    }
  };
  for (const CollisionPair& pair : listed)
  {
    if (canTouchSoon(body, pair))
    {
      keep_others_before(&pair);
      const bool shared = old != pairs_.end() && !comesBefore(pair, *old);
      merged_.push_back({ pair.voxel_a, pair.voxel_b, shared ? old->robots | bit : bit });
      old += shared ? 1 : 0;
    }
  }
  keep_others_before(nullptr);
  pairs_.swap(merged_);
}
}  // namespace devo_evo
