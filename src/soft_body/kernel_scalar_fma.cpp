#include "kernel-inl.h"

namespace devo_evo
{
const Kernel* scalarFmaKernel()
{
#if defined(__FMA__)
  static const Kernel kernel = { PackTraits<double>::LANES, step<double> };
  return &kernel;
#else
  return nullptr;
#endif
}
}  // namespace devo_evo
