#include "benchmark/kernel_parts-inl.h"

namespace devo_evo
{
const KernelParts* scalarKernelParts()
{
  static constexpr KernelParts parts = kernelParts<double>();
  return &parts;
}
}  // namespace devo_evo
