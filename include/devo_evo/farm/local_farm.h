#pragma once

#include "devo_evo/farm/farm.h"
#include "devo_evo/soft_body/simulation.h"

#include <memory>

namespace devo_evo
{
/// A farm of threads in this process. Destroying it abandons what is under way, at once.
/// An error in a thread ends the farm's work: collect() throws it, then and ever after.
/// @param threads 1 or more. @param instruction_set what they compute with.
/// @throw std::system_error if the threads cannot be started.
std::unique_ptr<Farm> makeLocalFarm(const SoftBodySettings& settings, int threads,
                                    InstructionSet instruction_set = bestInstructionSet());
}  // namespace devo_evo
