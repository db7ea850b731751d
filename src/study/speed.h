#pragma once

#include "devo_evo/soft_body/simulation.h"

namespace devo_evo
{
/// How many robots this machine simulates in a second, measured for about as long. For people; no result depends on it.
double evaluationsPerSecond(const SoftBodySettings& body, int threads, InstructionSet instruction_set);
}  // namespace devo_evo
