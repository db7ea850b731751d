#pragma once

#include "devo_evo/experiment/parameters.h"

#include <vector>

namespace devo_evo
{
/// The part of the table of parameters that is about studies.
std::vector<ParameterSpec> studySpecs();
}  // namespace devo_evo
