#pragma once

#include "devo_evo/evolution/body.h"

#include <string>

namespace devo_evo
{
constexpr double VELOCITY_WINDOW = 0.5;  // [s]

/// What all kinds of bodies ask of an evaluation, by their measures. @throw InvalidInput
void checkEvaluation(const Body& body, const Evaluation& evaluation);

/// @throw InvalidInput naming the value and where it must lie.
void requireWithin(const std::string& name, double value, double low, double high);
}  // namespace devo_evo
