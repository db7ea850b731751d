#pragma once

#include "kernel.h"

#include <cstdint>
#include <vector>

namespace devo_evo
{
/// The arrays that a batch's BatchState refers to; each is described there.
struct BatchMemory
{
  /// Numbers of one cache line, aligned as every instruction set wants it.
  struct alignas(64) Row
  {
    double numbers[8];
  };

  /// All numbers 0, all bonds in the small-angle regime, no voxel held.
  BatchMemory(const BodyModel& model, int lanes);

  /// Lets a state refer to these arrays, until they are moved or assigned to.
  void lendTo(BatchState& state);

  std::vector<Row> voxels;
  std::vector<Row> bonds;
  std::vector<Row> sideways;
  std::vector<Row> loads;
  std::vector<Row> collision_forces;
  std::vector<uint8_t> collided;
  std::vector<uint8_t> small_angle;
  std::vector<uint8_t> was_sideways;
  std::vector<uint8_t> static_friction;
};
}  // namespace devo_evo
