#include "kernel-inl.h"

namespace devo_evo
{
const Kernel* avx512Kernel()
{
#if defined(__AVX512F__)
  static const Kernel kernel = { PackTraits<Pack8>::LANES, step<Pack8> };
  return &kernel;
#else
  return nullptr;
#endif
}
}  // namespace devo_evo
