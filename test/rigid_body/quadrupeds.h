#pragma once

#include "devo_evo/rigid_body/quadruped.h"

#include <array>

namespace devo_evo
{
// Quadrupeds made by hand. Weights are those of sine and cosine: (1, 0) swings to the front first, (-1, 0) to the rear.

/// All legs of one length, for life, and motionless.
inline QuadrupedProgram motionless(double leg_length)
{
  QuadrupedProgram program;
  program.leg_length_initial.fill(leg_length);
  program.leg_length_final.fill(leg_length);
  return program;
}

inline QuadrupedProgram withWeights(double leg_length, const std::array<double, SYNAPSE_COUNT>& weights)
{
  QuadrupedProgram program = motionless(leg_length);
  program.weight_initial = weights;
  program.weight_final = weights;
  return program;
}

/// Long legs that bound: the front pair against the hind pair, half a cycle apart.
inline QuadrupedProgram walker(double leg_length = 1.0)
{
  return withWeights(leg_length, { 1.0, 0.0, 1.0, 0.0, -1.0, 0.0, -1.0, 0.0 });
}

/// Trots on legs that are half out, and draws them in over its life.
inline QuadrupedProgram latecomer()
{
  QuadrupedProgram program = withWeights(0.5, { 1.0, 0.0, -1.0, 0.0, -1.0, 0.0, 1.0, 0.0 });
  program.leg_length_final.fill(0.0);
  program.weight_final[1] = -0.4;
  return program;
}

/// Short legs that push like a walker's.
inline QuadrupedProgram roller()
{
  return walker(0.0);
}
}  // namespace devo_evo
