#pragma once

#include "archive/connection.h"

#include <memory>
#include <vector>

namespace devo_evo
{
/// Does nothing if they stand there already, or if there are none.
void writeFounders(Connection& connection, const EvolutionSettings& settings, const GenomeLayout& layout);

/// @return none if all founders are random. @throw DamagedArchive if ids have gaps or arrays do not fit the body.
std::shared_ptr<const std::vector<Genome>> readFounders(Connection& connection, const GenomeLayout& layout);
}  // namespace devo_evo
