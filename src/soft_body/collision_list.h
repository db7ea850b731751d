#pragma once

#include "kernel.h"

#include "devo_evo/soft_body/lattice.h"

#include <array>
#include <cstdint>
#include <vector>

namespace devo_evo
{
/// Which pairs of voxels each robot of a batch has to test for collision (docs/physics.md 3).
class CollisionList
{
public:
  /// @param lanes number of lanes in the batch's arrays; @param robots how many of them are used.
  CollisionList(const Lattice& lattice, double voxel_size, int lanes, int robots);

  /// Before a step: lists the close pairs of each robot that has moved far enough since its last listing.
  /// @param voxels as BatchState::voxels. @param max_speed_squared as BatchState has it after the last step.
  void update(const double* voxels, const double* max_speed_squared, double dt);

  /// Pairs listed for at least one robot, in ascending order of (voxel_a, voxel_b).
  const std::vector<CollisionPair>& pairs() const { return pairs_; }

private:
  /// One robot's state, read from the batch's arrays.
  struct Body
  {
    const double* voxels;
    int lanes;
    int robot;

    double at(int voxel, int field) const { return voxels[(voxel * VOXEL_FIELDS + field) * lanes + robot]; }
  };

  /// Where a surface voxel is, and how near another one, of a higher number, has to be to be listed with it.
  struct Place
  {
    std::array<double, 3> position;  ///< [m]
    double reach_square;             ///< [m^2]
  };

  void readPlaces(const Body& body);
  static bool isClose(const Place& a, const Place& b);
  void findAmongCandidates();
  void findByCells();
  void list(const Body& body);

  Lattice lattice_;
  double voxel_size_;
  int lanes_;
  bool listed_before_ = false;
  std::vector<double> motion_;             ///< (robots): farthest that a voxel can have moved, in voxel sizes
  std::vector<Place> places_;              ///< (voxels) of one robot; unset within the body
  std::vector<CollisionPair> candidates_;  ///< of a small body: all pairs far enough apart in the lattice
  std::vector<CollisionPair> found_;       ///< the close pairs of one robot, ascending
  std::vector<CollisionPair> pairs_;
  std::vector<CollisionPair> merged_;  ///< kept to save allocations
};
}  // namespace devo_evo
