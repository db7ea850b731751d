#include "benchmark/kernel_parts-inl.h"
#include "benchmark/processor_limits-inl.h"

namespace devo_evo
{
const KernelParts* avx512KernelParts()
{
#if defined(__AVX512F__)
  static constexpr KernelParts parts = kernelParts<Pack8>();
  return &parts;
#else
  return nullptr;
#endif
}

const ProcessorLimits* avx512Limits()
{
#if defined(__AVX512F__)
  static constexpr ProcessorLimits limits = processorLimits<Pack8>();
  return &limits;
#else
  return nullptr;
#endif
}
}  // namespace devo_evo
