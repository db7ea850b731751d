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

/// The kernel's moveVoxels(), up to a part.
template <int LAST, class Real>
inline void moveVoxelsUntil(const BodyModel& model, const StepClock& clock, const Group<Real>& group,
                            Voxel<Real>* voxels, uint8_t* static_friction, StepSums<Real>& sums)
{
  if constexpr (LAST >= BOOK_KEEPING)
  {
    moveVoxels(model, clock, group, voxels, static_friction, sums);
    return;
  }
  for (int i = group.first; i < group.end; ++i)
  {
    const Vector<Real> force = totalForce(model, group.loads[i - group.first], voxels[i], static_friction[i]);
    keep(force);
    if constexpr (LAST >= TRANSLATION)
    {
      integrateTranslation(model, force, voxels[i]);
    }
  }
  for (int i = group.first; LAST >= ROTATION && i < group.end; ++i)
  {
    integrateRotation(model, group.loads[i - group.first].moment, voxels[i]);
  }
  for (int i = group.first; LAST >= ACTUATION && i < group.end; ++i)
  {
    voxels[i].scale = nextScale(model, clock, voxels[i]);
  }
}

/// The kernel's step(), up to a part.
template <int LAST, class Real>
void stepUntil(const BodyModel& shared_model, const StepClock& shared_clock, BatchState& state)
{
  const BodyModel model = shared_model;
  const StepClock clock = shared_clock;
  auto* const voxels = reinterpret_cast<Voxel<Real>*>(state.voxels);
  const Memories<Real> memories = memoriesOf<Real>(state);
  const Real zero = constant<Real>(0.0);
  StepSums<Real> sums = { zero, zero, zero };
  applyCollisions(model, voxels, state);
  LoadRing<Real> ring(model, state);
  Group<Real> group;
  int first_number = 0;
  for (group.first = 0; LAST >= DEFORMATION && group.first < model.voxel_count; group.first = group.end)
  {
    group.end = group.first + VOXEL_GROUP < model.voxel_count ? group.first + VOXEL_GROUP : model.voxel_count;
    deformBonds(first_number, model, voxels, state, group);
    first_number += group.bond_count;
    fetchAhead(group.end, first_number, model, voxels, memories);
    keep(group);
    if constexpr (LAST >= ROTATIONS)
    {
      rotateEndsOfBonds(model, state, group);
      keep(group);
    }
    if constexpr (LAST >= LOADS)
    {
      applyForcesOfBonds(model, clock.first_step, memories, ring, group);
    }
    if constexpr (LAST >= FLOOR)
    {
      moveVoxelsUntil<LAST>(model, clock, group, voxels, state.static_friction, sums);
    }
  }
  report(model, sums, state);
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
