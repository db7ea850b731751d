#pragma once

#include "devo_evo/interchange/phylogeny.h"
#include "devo_evo/soft_body/developmental_program.h"
#include "devo_evo/soft_body/evaluation.h"
#include "devo_evo/soft_body/settings.h"

namespace devo_evo
{
/// What a trace has a line for.
enum class TraceKind
{
  CENTER_OF_MASS,  ///< each moment: position and mean orientation of the whole body
  VOXELS           ///< each voxel at each moment: its state
};

/// Simulates a life and writes it as CSV with a header: the start, then the first step at or after every multiple of
/// `interval`, then the end. SI units, frames as VoxelState.
/// @param interval of simulator time [s]; not below a time step.
/// @return the evaluation. @throw InvalidInput if program, settings or interval are invalid.
Evaluation writeTrace(const SoftBodySettings& settings, const DevelopmentalProgram& program, TraceKind kind,
                      double interval, const LineSink& sink);
}  // namespace devo_evo
