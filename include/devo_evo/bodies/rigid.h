#pragma once

#include "devo_evo/rigid_body/quadruped.h"
#include "devo_evo/soft_body/developmental_program.h"
#include "devo_evo/soft_body/evaluation.h"

namespace devo_evo
{
// Between what all bodies have in common and what the quadruped has.

/// @pre the arrays have the sizes of the rigid body's layout.
QuadrupedProgram toQuadruped(const DevelopmentalProgram& program);

/// @param settings of the world that it lived in.
Evaluation toEvaluation(const QuadrupedEvaluation& life, const RigidBodySettings& settings);
}  // namespace devo_evo
