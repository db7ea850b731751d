#pragma once

#include "devo_evo/rigid_body/settings.h"
#include "devo_evo/soft_body/simulation.h"

namespace devo_evo
{
/// How many robots this machine simulates in a second, measured for about as long. For people; no result depends on it.
double evaluationsPerSecond(const SoftBodySettings& body, int threads, InstructionSet instruction_set);

/// Of quadrupeds, as long as each thread has a core. Measures one thread for a part of a second.
double quadrupedsPerSecond(const RigidBodySettings& world, int threads);
}  // namespace devo_evo
