#pragma once

#include "devo_evo/soft_body/settings.h"

#include <string>
#include <vector>

namespace devo_evo
{
/// What a robot's genome says about its body and control: per voxel, values at birth and at the end of life, between
/// which they change linearly (paper, Eq. 1). Arrays have one entry per voxel, in the order index = x + grid_x * (y +
/// grid_y * z). Without development the final arrays equal the initial ones.
struct DevelopmentalProgram
{
  std::vector<double> size_gene_initial;  ///< at birth [1, within -1 to 1]; resting length = L (1 + 0.75 gene)
  std::vector<double> size_gene_final;    ///< at the end of life, like size_gene_initial
  std::vector<double> phase_initial;      ///< phase offset of actuation at birth [cycles, within -1 to 1]
  std::vector<double> phase_final;        ///< at the end of life, like phase_initial

  bool operator==(const DevelopmentalProgram& other) const;
};

/// Values this far beyond a limit are accepted: they come from files in single precision.
constexpr double GENE_TOLERANCE = 1e-7;

/// @throw InvalidInput unless every array has one finite entry within [-1, 1] (up to GENE_TOLERANCE) per voxel; the
/// message
///        names array, index and value, or the array's size and the size the grid wants.
void validate(const DevelopmentalProgram& program, const SoftBodySettings& settings);

/// Developmental windows: how much of all possible change the program uses [1, 0 to 1].
/// Morphology: W_L, paper Eq. 5. Control: W_Phi, paper Eq. 6 with the phase range of 2 phase_limit [cycles].
double morphologyWindow(const DevelopmentalProgram& program);
double controlWindow(const DevelopmentalProgram& program, double phase_limit);
}  // namespace devo_evo
