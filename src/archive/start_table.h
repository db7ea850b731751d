#pragma once

#include "archive/connection.h"

#include <vector>

namespace devo_evo
{
/// Notes that an evolver opened the archive.
/// @throw ArchiveError if its engine gives other results than the one that made the archive.
void recordStart(Connection& connection, const Provenance& provenance);

/// Notes that the evolver that opened it last closes it.
void recordStop(Connection& connection);

/// Notes who has evaluated robots since the archive was opened last.
void recordEvaluators(Connection& connection, const std::vector<Evaluator>& evaluators);

std::vector<Start> readStarts(Connection& connection);
}  // namespace devo_evo
