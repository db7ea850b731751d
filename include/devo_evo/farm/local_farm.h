#pragma once

#include "devo_evo/evolution/body.h"
#include "devo_evo/farm/farm.h"

#include <memory>

namespace devo_evo
{
/// A farm of threads in this process. Destroying it abandons what is under way, at once.
/// An error in a thread ends the farm's work: collect() throws it, then and ever after.
/// @param threads 1 or more. @param instruction_set what they compute with.
/// @throw std::system_error if the threads cannot be started.
std::unique_ptr<Farm> makeLocalFarm(std::shared_ptr<const Body> body, int threads,
                                    InstructionSet instruction_set = bestInstructionSet());
}  // namespace devo_evo
