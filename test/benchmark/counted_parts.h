#pragma once

#include "benchmark/kernel_parts.h"

namespace devo_evo
{
/// How many operations on packs were done.
struct OperationCounts
{
  double multiply_adds = 0;  ///< fused multiplications and additions
  double simple = 0;         ///< additions, subtractions and multiplications; negations are none: they come for free
  double divisions = 0;
  double square_roots = 0;
  double selections = 0;  ///< comparisons, selections, and operations on bits and masks
};

/// Advances a batch of 1, 4 or 8 lanes by a step that ends after `part`, and counts what that takes.
OperationCounts countOperations(KernelPart part, int lanes, const BodyModel& model, const StepClock& clock,
                                BatchState& state);
}  // namespace devo_evo
