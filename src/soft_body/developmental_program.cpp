#include "devo_evo/soft_body/developmental_program.h"

#include "devo_evo/soft_body/text.h"

#include <cmath>

namespace devo_evo
{
namespace
{
void validateArray(const char* name, const std::vector<double>& values, const SoftBodySettings& settings)
{
  if (values.size() != static_cast<size_t>(settings.voxelCount()))
  {
    throw InvalidInput(std::string(name) + " has " + toText(static_cast<int64_t>(values.size())) +
                       " values; a grid of " + toText(settings.grid_x) + "x" + toText(settings.grid_y) + "x" +
                       toText(settings.grid_z) + " voxels needs " + toText(settings.voxelCount()));
  }
  for (size_t i = 0; i < values.size(); ++i)
  {
    if (!(std::abs(values[i]) <= 1.0 + GENE_TOLERANCE))
    {
      throw InvalidInput(std::string(name) + "[" + toText(static_cast<int64_t>(i)) + "] is " + toText(values[i]) +
                         "; it must lie within -1 to 1");
    }
  }
}

/// Mean of |final - initial| over all voxels, as a share of the range that values may take.
double developmentalWindow(const std::vector<double>& initial, const std::vector<double>& final, double range)
{
  double change = 0.0;
  for (size_t i = 0; i < initial.size(); ++i)
  {
    change += std::abs(final[i] - initial[i]);
  }
  return change / (static_cast<double>(initial.size()) * range);
}
}  // namespace

bool DevelopmentalProgram::operator==(const DevelopmentalProgram& other) const
{
  return size_gene_initial == other.size_gene_initial && size_gene_final == other.size_gene_final &&
         phase_initial == other.phase_initial && phase_final == other.phase_final;
}

void validate(const DevelopmentalProgram& program, const SoftBodySettings& settings)
{
  validateArray("size_gene_initial", program.size_gene_initial, settings);
  validateArray("size_gene_final", program.size_gene_final, settings);
  validateArray("phase_initial", program.phase_initial, settings);
  validateArray("phase_final", program.phase_final, settings);
}

double morphologyWindow(const DevelopmentalProgram& program)
{
  return developmentalWindow(program.size_gene_initial, program.size_gene_final, 2.0);
}

double controlWindow(const DevelopmentalProgram& program, double phase_limit)
{
  return developmentalWindow(program.phase_initial, program.phase_final, 2.0 * phase_limit);
}
}  // namespace devo_evo
