// The kernel's step in slices, made of the kernel's own functions, for every number type.
#pragma once

#include "benchmark/kernel_parts.h"

#include "soft_body/kernel-inl.h"

namespace devo_evo
{
namespace
{
/// Makes the compiler believe that somebody reads `value`, and may have changed all memory.
template <class Value>
inline void keep(const Value& value)
{
  asm volatile("" : : "g"(&value) : "memory");
}

/// The kernel's moveVoxel(), up to a part.
template <int LAST, class Real>
inline void moveVoxelUntil(const BodyModel& model, const StepClock& clock, bool in_top_layer, Voxel<Real>& voxel,
                           uint8_t& static_friction_bits, StepSums<Real>& sums)
{
  if constexpr (LAST >= BOOK_KEEPING)
  {
    moveVoxel(model, clock, in_top_layer, voxel, static_friction_bits, sums);
    return;
  }
  const Vector<Real> velocity = constant<Real>(model.inverse_mass) * voxel.momentum;
  Vector<Real> force = multiplyAdd(constant<Real>(-model.translation_drag), velocity, voxel.force);
  force.z = force.z - constant<Real>(model.weight);
  applyFloor(model, penetration(voxel), velocity, voxel, force, static_friction_bits);
  keep(force);
  if constexpr (LAST >= TRANSLATION)
  {
    integrateTranslation(model, force, voxel);
  }
  if constexpr (LAST >= ROTATION)
  {
    integrateRotation(model, voxel);
  }
  if constexpr (LAST >= ACTUATION)
  {
    voxel.scale = nextScale(model, clock, voxel);
  }
}

/// The kernel's step(), up to a part.
template <int LAST, class Real>
void stepUntil(const BodyModel& model, const StepClock& clock, BatchState& state)
{
  auto* const voxels = reinterpret_cast<Voxel<Real>*>(state.voxels);
  auto* const memories = reinterpret_cast<BondMemory<Real>*>(state.bonds);
  const Real zero = constant<Real>(0.0);
  StepSums<Real> sums = { zero, zero, zero };
  applyCollisions(model, voxels, state);
  Bond<Real> bonds[3 * GROUP];
  int first_number = 0;
  for (int first = 0; LAST >= DEFORMATION && first < model.voxel_count; first += GROUP)
  {
    const int end = first + GROUP < model.voxel_count ? first + GROUP : model.voxel_count;
    int count = 0;
    for (int voxel = first; voxel < end; ++voxel)
    {
      count += deformBondsOf(voxel, first_number + count, model, voxels, state, bonds + count);
    }
    fetchAhead(end, first_number + count, model, voxels, memories);
    keep(bonds);
    for (int i = 0; LAST >= ROTATIONS && i < count; ++i)
    {
      rotateEnds(bonds[i]);
      checkDivergence(model, bonds[i], state);
    }
    keep(bonds);
    for (int i = 0; LAST >= LOADS && i < count; ++i)
    {
      applyForces(model, clock.first_step, bonds[i], memories[bonds[i].number]);
    }
    for (int voxel = first; LAST >= FLOOR && voxel < end; ++voxel)
    {
      moveVoxelUntil<LAST>(model, clock, model.in_top_layer[voxel] != 0, voxels[voxel], state.static_friction[voxel],
                           sums);
    }
    first_number += count;
  }
  const Real inverse_mass_square = constant<Real>(model.inverse_mass * model.inverse_mass);
  const Real max_speed_square = inverse_mass_square * sums.max_momentum_square;
  std::memcpy(state.max_speed_squared, &max_speed_square, sizeof max_speed_square);
  std::memcpy(state.top_contacts, &sums.top_contacts, sizeof sums.top_contacts);
  std::memcpy(state.other_contacts, &sums.other_contacts, sizeof sums.other_contacts);
}

template <class Real>
constexpr KernelParts kernelParts()
{
  return { PackTraits<Real>::LANES,
           { stepUntil<COLLISIONS, Real>, stepUntil<DEFORMATION, Real>, stepUntil<ROTATIONS, Real>,
             stepUntil<LOADS, Real>, stepUntil<FLOOR, Real>, stepUntil<TRANSLATION, Real>, stepUntil<ROTATION, Real>,
             stepUntil<ACTUATION, Real>, stepUntil<BOOK_KEEPING, Real> } };
}
}  // namespace
}  // namespace devo_evo
