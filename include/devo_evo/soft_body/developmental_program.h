#pragma once

#include "devo_evo/soft_body/settings.h"

#include <string>
#include <vector>

namespace devo_evo
{
/// What a robot's genome says about its body and control: values at birth and at the end of life, between which they
/// change linearly (paper, Eq. 1). What the numbers are, and how many there are, is up to the kind of body. Without
/// development the final arrays equal the initial ones.
///
/// Of soft bodies, one entry per voxel, in the order index = x + grid_x * (y + grid_y * z). Morphology is a size gene
/// [1, within -1 to 1], resting length = L (1 + 0.75 gene); control is the phase offset of actuation [cycles, within -1
/// to 1]. Of rigid bodies: QuadrupedProgram.
struct DevelopmentalProgram
{
  std::vector<double> morphology_initial;  ///< at birth
  std::vector<double> morphology_final;    ///< at the end of life, like morphology_initial
  std::vector<double> control_initial;     ///< at birth
  std::vector<double> control_final;       ///< at the end of life, like control_initial

  bool operator==(const DevelopmentalProgram& other) const;
};

/// Values this far beyond a limit are accepted: they come from files in single precision.
constexpr double GENE_TOLERANCE = 1e-7;

/// Of a soft body. @throw InvalidInput unless every array has one finite entry within [-1, 1] (up to GENE_TOLERANCE)
/// per voxel; the message names array, index and value, or the array's size and the size the grid wants.
void validate(const DevelopmentalProgram& program, const SoftBodySettings& settings);
}  // namespace devo_evo
