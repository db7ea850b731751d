#include "devo_evo/soft_body/simulation.h"

#include "kernel.h"

namespace devo_evo
{
bool isSupported(InstructionSet instruction_set)
{
  switch (instruction_set)
  {
    case InstructionSet::SCALAR:
      return true;
#if defined(__x86_64__)
    case InstructionSet::AVX2:
      return avx2Kernel() != nullptr && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    case InstructionSet::AVX512:
      return avx512Kernel() != nullptr && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
             __builtin_cpu_supports("avx512vl");
#else
    default:
      break;
#endif
  }
  return false;
}

InstructionSet bestInstructionSet()
{
  for (const InstructionSet candidate : { InstructionSet::AVX512, InstructionSet::AVX2 })
  {
    if (isSupported(candidate))
    {
      return candidate;
    }
  }
  return InstructionSet::SCALAR;
}

std::string toString(InstructionSet instruction_set)
{
  switch (instruction_set)
  {
    case InstructionSet::AVX2:
      return "avx2";
    case InstructionSet::AVX512:
      return "avx512";
    case InstructionSet::SCALAR:
      break;
  }
  return "scalar";
}

InstructionSet parseInstructionSet(const std::string& name)
{
  if (name == "auto")
  {
    return bestInstructionSet();
  }
  for (const InstructionSet candidate : { InstructionSet::SCALAR, InstructionSet::AVX2, InstructionSet::AVX512 })
  {
    if (name == toString(candidate))
    {
      if (!isSupported(candidate))
      {
        throw InvalidInput("instruction set " + name + " is not supported by this processor; \"auto\" picks the best");
      }
      return candidate;
    }
  }
  throw InvalidInput("instruction set \"" + name + "\" is unknown; it must be auto, scalar, avx2 or avx512");
}

int laneCount(InstructionSet instruction_set)
{
  switch (instruction_set)
  {
    case InstructionSet::AVX2:
      return 4;
    case InstructionSet::AVX512:
      return 8;
    case InstructionSet::SCALAR:
      break;
  }
  return 1;
}
}  // namespace devo_evo
