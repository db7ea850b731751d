#pragma once

#include "kernel.h"

#include "devo_evo/soft_body/lattice.h"

#include <cstdint>
#include <vector>

namespace devo_evo
{
/// Which pairs of voxels each robot of a batch has to test for collision (docs/physics.md 3). Of the pairs that the
/// model lists, only those are given that can touch before the next look at them: the others would add nothing.
class CollisionList
{
public:
  /// @param longest_stroke how far actuation can lengthen a voxel [m]. @param lanes number of lanes in the batch's
  /// arrays. @param robots how many of them are used.
  CollisionList(const Lattice& lattice, double voxel_size, double longest_stroke, int lanes, int robots);

  /// Before a step: looks again at each robot that has moved far enough since the last look.
  /// @param voxels as BatchState::voxels. @param max_speed_squared as BatchState has it after the last step.
  void update(const double* voxels, const double* max_speed_squared, double dt);

  /// Pairs that at least one robot has to test, in ascending order of (voxel_a, voxel_b).
  const std::vector<CollisionPair>& pairs() const { return pairs_; }

private:
  /// One robot's state, read from the batch's arrays.
  struct Body
  {
    const double* voxels;
    int lanes;
    int robot;

    double at(int voxel, int field) const { return voxels[(voxel * VOXEL_FIELDS + field) * lanes + robot]; }

    /// The voxel's x; y and z follow at a distance of `lanes`.
    const double* place(int voxel) const { return &voxels[(voxel * VOXEL_FIELDS + POSITION) * lanes + robot]; }
  };

  /// What is known of one robot's pairs, ascending.
  struct RobotPairs
  {
    double motion_since_listing = 0.0;  ///< farthest that a voxel can have moved, in voxel sizes
    double motion_since_look = 0.0;
    std::vector<CollisionPair> listed;
  };

  bool isClose(const Body& body, int voxel_a, int voxel_b) const;
  bool canTouchSoon(const Body& body, const CollisionPair& pair) const;
  void listFromCandidates(const Body& body, std::vector<CollisionPair>& listed) const;
  void listByCells(const Body& body, std::vector<CollisionPair>& listed) const;
  void list(const Body& body, std::vector<CollisionPair>& listed) const;
  void replacePairs(const Body& body, const std::vector<CollisionPair>& listed);

  Lattice lattice_;
  double voxel_size_;
  double longest_stroke_;
  int lanes_;
  bool listed_before_ = false;
  std::vector<RobotPairs> robots_;
  std::vector<CollisionPair> candidates_;  ///< of a small body: all pairs far enough apart in the lattice
  std::vector<CollisionPair> pairs_;
  std::vector<CollisionPair> merged_;  ///< kept to save allocations
};
}  // namespace devo_evo
