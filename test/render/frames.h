#pragma once

#include "devo_evo/render/life_playback.h"
#include "devo_evo/soft_body/lattice.h"

#include <cstddef>

namespace devo_evo
{
/// A body of this grid and pitch at rest on its lattice, every voxel as long as the pitch.
inline RobotFrame restingFrame(const SoftBodySettings& settings)
{
  const Lattice lattice(settings);
  const double L = settings.voxel_size;
  RobotFrame frame;
  for (int voxel = 0; voxel < lattice.voxelCount(); ++voxel)
  {
    const auto [x, y, z] = lattice.coordinates(voxel);
    frame.parts.push_back(
        { L * Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5), Eigen::Quaterniond::Identity(), L, L, 0.0, 0.0 });
    frame.center_of_mass += frame.parts.back().position / lattice.voxelCount();
  }
  return frame;
}

inline SoftBodySettings bodyOf(int grid_x, int grid_y, int grid_z)
{
  SoftBodySettings settings;
  settings.grid_x = grid_x;
  settings.grid_y = grid_y;
  settings.grid_z = grid_z;
  return settings;
}
}  // namespace devo_evo
