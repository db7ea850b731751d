#pragma once

#include "devo_evo/experiment/parameters.h"

namespace devo_evo
{
/// The parameters of a study of this scale of which none is given.
Parameters parametersAtScale(Scale scale);
}  // namespace devo_evo
