#pragma once

#include <cstdint>
#include <vector>

namespace devo_evo
{
/// Numbers in [-1, 1) that look random (SplitMix64), the same everywhere.
inline std::vector<double> scrambledGenes(uint64_t& state, int count)
{
  std::vector<double> genes;
  for (int i = 0; i < count; ++i)
  {
    uint64_t bits = state += 0x9E3779B97F4A7C15u;
    bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9u;
    bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBu;
    bits ^= bits >> 31;
    genes.push_back(static_cast<double>(bits >> 11) * 0x1p-52 - 1.0);
  }
  return genes;
}
}  // namespace devo_evo
