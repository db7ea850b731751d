#include "benchmark/kernel_parts-inl.h"

namespace devo_evo
{
const KernelParts* scalarFmaKernelParts()
{
#if defined(__FMA__)
  static constexpr KernelParts parts = kernelParts<double>();
  return &parts;
#else
  return nullptr;
#endif
}
}  // namespace devo_evo
