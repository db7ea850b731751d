#include "devo_evo/soft_body/lattice.h"

#include <cstdlib>

namespace devo_evo
{
Lattice::Lattice(int size_x, int size_y, int size_z) : size_x_(size_x), size_y_(size_y), size_z_(size_z)
{
  const std::array<int, 3> size = { size_x, size_y, size_z };
  const std::array<int, 3> stride = { 1, size_x, size_x * size_y };
  for (int voxel = 0; voxel < voxelCount(); ++voxel)
  {
    const std::array<int, 3> position = { voxel % size_x, voxel / size_x % size_y, voxel / (size_x * size_y) };
    coordinates_.push_back(position);
    bool on_surface = false;
    for (size_t axis = 0; axis < 3; ++axis)
    {
      const bool has_upper_neighbour = position[axis] + 1 < size[axis];
      const bool has_lower_neighbour = position[axis] > 0;
      if (has_upper_neighbour)
      {
        bonds_.push_back({ voxel, voxel + stride[axis], static_cast<int>(axis) });
      }
      on_surface = on_surface || !has_upper_neighbour || !has_lower_neighbour;
    }
    if (on_surface)
    {
      surface_.push_back(voxel);
    }
  }
}

int Lattice::manhattanDistance(int voxel_a, int voxel_b) const
{
  const std::array<int, 3>& a = coordinates(voxel_a);
  const std::array<int, 3>& b = coordinates(voxel_b);
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
}

int Lattice::mirrored(int index) const
{
  const std::array<int, 3> position = coordinates(index);
  return this->index(size_x_ - 1 - position[0], position[1], position[2]);
}
}  // namespace devo_evo
