#include "devo_evo/soft_body/evaluation.h"

#include "devo_evo/soft_body/text.h"

namespace devo_evo
{
std::string Divergence::describe(double time_step) const
{
  return "diverged at step " + toText(step) + " (" + toText(static_cast<double>(step) * time_step) + " s): bond " +
         toText(bond) + " has strain " + toText(strain);
}
}  // namespace devo_evo
