#include "devo_evo/rigid_body/quadruped_program.h"

#include "devo_evo/soft_body/developmental_program.h"
#include "devo_evo/soft_body/text.h"

#include <string>

namespace devo_evo
{
namespace
{
template <size_t N>
void checkArray(const char* name, const std::array<double, N>& values, double minimum, double maximum)
{
  for (size_t i = 0; i < N; ++i)
  {
    if (!(values[i] >= minimum - GENE_TOLERANCE && values[i] <= maximum + GENE_TOLERANCE))
    {
      throw InvalidInput(std::string(name) + "[" + toText(static_cast<int64_t>(i)) + "] is " + toText(values[i]) +
                         "; it must lie within " + toText(minimum) + " to " + toText(maximum));
    }
  }
}

double between(double initial, double final, double share)
{
  return initial + (final - initial) * share;
}
}  // namespace

double QuadrupedProgram::legLength(size_t leg, double age) const
{
  return between(leg_length_initial[leg], leg_length_final[leg], age);
}

double QuadrupedProgram::weight(size_t leg, size_t generator, double age) const
{
  const size_t synapse = GENERATOR_COUNT * leg + generator;
  return between(weight_initial[synapse], weight_final[synapse], age);
}

void validate(const QuadrupedProgram& program)
{
  checkArray("leg_length_initial", program.leg_length_initial, 0.0, 1.0);
  checkArray("leg_length_final", program.leg_length_final, 0.0, 1.0);
  checkArray("weight_initial", program.weight_initial, -1.0, 1.0);
  checkArray("weight_final", program.weight_final, -1.0, 1.0);
}
}  // namespace devo_evo
