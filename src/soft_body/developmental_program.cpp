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
}  // namespace

bool DevelopmentalProgram::operator==(const DevelopmentalProgram& other) const
{
  return morphology_initial == other.morphology_initial && morphology_final == other.morphology_final &&
         control_initial == other.control_initial && control_final == other.control_final;
}

void validate(const DevelopmentalProgram& program, const SoftBodySettings& settings)
{
  validateArray("size_gene_initial", program.morphology_initial, settings);
  validateArray("size_gene_final", program.morphology_final, settings);
  validateArray("phase_initial", program.control_initial, settings);
  validateArray("phase_final", program.control_final, settings);
}
}  // namespace devo_evo
