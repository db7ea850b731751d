#pragma once

#include "archive/connection.h"
#include "devo_evo/experiment/parameters.h"

#include <vector>

namespace devo_evo
{
/// What the archive says the experiment is; output stays empty. @throw DamagedArchive if a value cannot be used.
ExperimentSettings readSettings(Connection& connection);

/// Writes one parameter into table `parameters`.
void writeParameter(Connection& connection, const ParameterSpec& spec, const Parameters& parameters);

/// Writes all parameters that decide the results with these kinds of bodies, and how far the experiment goes.
void writeSettings(Connection& connection, const ExperimentSettings& settings, const std::vector<BodyKind>& kinds);

/// The resume rule. @throw ArchiveError naming each parameter with these kinds of bodies in which `wanted` differs from
/// what the archive says, unless it only tells how far the experiment goes.
void checkResumable(Connection& connection, const ExperimentSettings& wanted, const std::vector<BodyKind>& kinds);
}  // namespace devo_evo
