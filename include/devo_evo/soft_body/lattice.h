#pragma once

#include "devo_evo/soft_body/settings.h"

#include <array>
#include <vector>

namespace devo_evo
{
/// The grid of voxels that a body is made of: who neighbours whom (docs/physics.md 1 and 2).
class Lattice
{
public:
  /// A beam between face neighbours; voxel 1 is the one at the lower coordinate.
  struct Bond
  {
    int voxel_1;
    int voxel_2;
    int axis;  ///< 0: x, 1: y, 2: z
  };

  Lattice(int size_x, int size_y, int size_z);
  explicit Lattice(const SoftBodySettings& settings) : Lattice(settings.grid_x, settings.grid_y, settings.grid_z) {}

  int voxelCount() const { return size_x_ * size_y_ * size_z_; }

  /// Flat index of voxel (x, y, z).
  int index(int x, int y, int z) const { return x + size_x_ * (y + size_y_ * z); }

  /// Coordinates (x, y, z) of a flat index.
  const std::array<int, 3>& coordinates(int index) const { return coordinates_[static_cast<size_t>(index)]; }

  /// All bonds, by voxel 1 and then by axis.
  const std::vector<Bond>& bonds() const { return bonds_; }

  /// Voxels with fewer than six neighbours, ascending.
  const std::vector<int>& surface() const { return surface_; }

  /// Face-steps from one voxel to the other.
  int manhattanDistance(int voxel_a, int voxel_b) const;

  /// The voxel's mirror image in the plane of bilateral symmetry, x -> size_x - 1 - x.
  int mirrored(int index) const;

private:
  int size_x_, size_y_, size_z_;
  std::vector<std::array<int, 3>> coordinates_;  ///< kept since the search for collisions asks for them all the time
  std::vector<Bond> bonds_;
  std::vector<int> surface_;
};
}  // namespace devo_evo
