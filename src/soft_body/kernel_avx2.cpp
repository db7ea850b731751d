#include "kernel-inl.h"

namespace devo_evo
{
const Kernel* avx2Kernel()
{
#if defined(__AVX2__)
  static const Kernel kernel = { PackTraits<Pack4>::LANES, step<Pack4> };
  return &kernel;
#else
  return nullptr;
#endif
}
}  // namespace devo_evo
