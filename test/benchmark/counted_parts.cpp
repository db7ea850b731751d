#include "benchmark/counted_parts.h"

#include "benchmark/counted_pack.h"
#include "benchmark/kernel_parts-inl.h"

namespace devo_evo
{
OperationCounts countOperations(KernelPart part, int lanes, const BodyModel& model, const StepClock& clock,
                                BatchState& state)
{
  static constexpr KernelParts one = kernelParts<CountedPack<1>>();
  static constexpr KernelParts four = kernelParts<CountedPack<4>>();
  static constexpr KernelParts eight = kernelParts<CountedPack<8>>();
  const KernelParts& parts = lanes == 8 ? eight : lanes == 4 ? four : one;
  counts = OperationCounts{};
  parts.step_until[part](model, clock, state);
  return counts;
}
}  // namespace devo_evo
