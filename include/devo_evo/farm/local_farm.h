#pragma once

#include "devo_evo/farm/farm.h"
#include "devo_evo/soft_body/simulation.h"

namespace devo_evo
{
/// A farm of threads in this process.
/// @param threads 1 or more. @param instruction_set what they compute with.
std::unique_ptr<Farm> makeLocalFarm(const SoftBodySettings& settings, int threads,
                                    InstructionSet instruction_set = bestInstructionSet());
}  // namespace devo_evo
