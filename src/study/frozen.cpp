#include "study/frozen.h"

namespace devo_evo
{
namespace
{
void freeze(std::vector<double>& initial, std::vector<double>& final, Moment moment)
{
  for (size_t voxel = 0; voxel < initial.size(); ++voxel)
  {
    const double value = moment == Moment::BIRTH   ? initial[voxel]
                         : moment == Moment::DEATH ? final[voxel]
                                                   : 0.5 * (initial[voxel] + final[voxel]);
    initial[voxel] = final[voxel] = value;
  }
}
}  // namespace

std::string toString(Moment moment)
{
  return moment == Moment::BIRTH ? "birth" : moment == Moment::MIDLIFE ? "midlife" : "death";
}

std::string toString(Scope scope)
{
  return scope == Scope::BODY ? "body" : scope == Scope::CONTROL ? "control" : "both";
}

DevelopmentalProgram frozen(const DevelopmentalProgram& program, Moment moment, Scope scope)
{
  DevelopmentalProgram copy = program;
  if (scope != Scope::CONTROL)
  {
    freeze(copy.morphology_initial, copy.morphology_final, moment);
  }
  if (scope != Scope::BODY)
  {
    freeze(copy.control_initial, copy.control_final, moment);
  }
  return copy;
}
}  // namespace devo_evo
