#pragma once

#include "soft_body/kernel.h"

namespace devo_evo
{
/// What a step of the kernel consists of, in its order.
enum KernelPart : int
{
  COLLISIONS,    ///< forces between voxels of the listed pairs
  DEFORMATION,   ///< of bonds: relative pose, regime, shortest turn, turned frame
  ROTATIONS,     ///< of both ends of bonds: rotation vectors; test for divergence
  LOADS,         ///< of bonds: forces and moments, turned to the world and added to both voxels
  FLOOR,         ///< drag, weight, contact with the floor, friction
  TRANSLATION,   ///< integration of momentum and position
  ROTATION,      ///< integration of angular momentum and orientation
  ACTUATION,     ///< development and actuation of the resting length
  BOOK_KEEPING,  ///< loads set to zero, greatest speed, contacts counted
  KERNEL_PARTS
};

using StepFunction = void (*)(const BodyModel&, const StepClock&, BatchState&);

/// The kernel in slices.
struct KernelParts
{
  int lanes;
  StepFunction step_until[KERNEL_PARTS];  ///< a step that ends after the part; the last is a whole step
};

/// Operations whose rate bounds every kernel.
enum LimitingOperation : int
{
  MULTIPLY_ADD,
  DIVISION,
  SQUARE_ROOT,  ///< of a product
  LIMITING_OPERATIONS
};

/// What does nothing but one operation on packs, for a number of rounds; returns what nobody can know beforehand.
using LimitFunction = double (*)(int rounds);

/// How fast an instruction set can be on a processor.
struct ProcessorLimits
{
  static constexpr int INDEPENDENT = 12;  ///< operations per round that can overlap

  int lanes;
  LimitFunction independent[LIMITING_OPERATIONS];
  LimitFunction dependent[LIMITING_OPERATIONS];  ///< one per round, which waits for the one before
};

// As the kernels in kernel.h: null where the compiler's target has none.
const KernelParts* scalarKernelParts();
const KernelParts* scalarFmaKernelParts();  ///< see scalarFmaKernel()
const KernelParts* avx2KernelParts();
const KernelParts* avx512KernelParts();
const ProcessorLimits* avx2Limits();
const ProcessorLimits* avx512Limits();
}  // namespace devo_evo
