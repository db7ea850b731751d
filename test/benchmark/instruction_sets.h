#pragma once

#include "devo_evo/soft_body/simulation.h"

#include <vector>

namespace devo_evo
{
/// The instruction sets that this machine can be measured with, the slowest first.
inline std::vector<InstructionSet> measuredInstructionSets()
{
  std::vector<InstructionSet> measured;
  for (const InstructionSet candidate : { InstructionSet::SCALAR, InstructionSet::AVX2, InstructionSet::AVX512 })
  {
    if (isSupported(candidate))
    {
      measured.push_back(candidate);
    }
  }
  return measured;
}
}  // namespace devo_evo
