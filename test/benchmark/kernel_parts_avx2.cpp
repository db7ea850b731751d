#include "benchmark/kernel_parts-inl.h"
#include "benchmark/processor_limits-inl.h"

namespace devo_evo
{
const KernelParts* avx2KernelParts()
{
#if defined(__AVX2__)
  static constexpr KernelParts parts = kernelParts<Pack4>();
  return &parts;
#else
  return nullptr;
#endif
}

const ProcessorLimits* avx2Limits()
{
#if defined(__AVX2__)
  static constexpr ProcessorLimits limits = processorLimits<Pack4>();
  return &limits;
#else
  return nullptr;
#endif
}
}  // namespace devo_evo
