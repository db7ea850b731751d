#pragma once

#include "devo_evo/evolution/body.h"

namespace devo_evo
{
/// What all kinds of bodies ask of an evaluation, by their measures. @throw InvalidInput
void checkEvaluation(const Body& body, const Evaluation& evaluation);
}  // namespace devo_evo
