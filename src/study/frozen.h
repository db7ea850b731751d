#pragma once

#include "devo_evo/soft_body/developmental_program.h"

#include <string>

namespace devo_evo
{
/// Whose values a robot has all its life once its development is frozen.
enum class Moment
{
  BIRTH,
  MIDLIFE,
  DEATH
};

/// What of a robot is meant.
enum class Scope
{
  BODY,     ///< resting lengths
  CONTROL,  ///< phases
  BOTH
};

std::string toString(Moment moment);  ///< "birth", "midlife" or "death"
std::string toString(Scope scope);    ///< "body", "control" or "both"

/// The program without development in `scope`: its values there are those of `moment` for life. Frozen at birth in both
/// it is the paper's "Evo-Devo removed".
DevelopmentalProgram frozen(const DevelopmentalProgram& program, Moment moment, Scope scope);
}  // namespace devo_evo
