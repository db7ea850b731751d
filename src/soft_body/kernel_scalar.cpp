#include "kernel-inl.h"

namespace devo_evo
{
const Kernel* scalarKernel()
{
  static const Kernel kernel = { PackTraits<double>::LANES, step<double> };
  return &kernel;
}
}  // namespace devo_evo
