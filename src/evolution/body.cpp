#include "devo_evo/evolution/body.h"

#include <cmath>

namespace devo_evo
{
namespace
{
double window(const std::vector<double>& initial, const std::vector<double>& final, const GenomePart& part)
{
  double change = 0.0;
  for (size_t i = 0; i < initial.size(); ++i)
  {
    change += std::abs(final[i] - initial[i]);
  }
  return change / (static_cast<double>(initial.size()) * (part.maximum - part.minimum));
}
}  // namespace

double morphologyWindow(const DevelopmentalProgram& program, const GenomeLayout& layout)
{
  return window(program.morphology_initial, program.morphology_final, layout.morphology);
}

double controlWindow(const DevelopmentalProgram& program, const GenomeLayout& layout)
{
  return window(program.control_initial, program.control_final, layout.control);
}
}  // namespace devo_evo
