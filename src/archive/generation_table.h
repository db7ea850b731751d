#pragma once

#include "archive/archived_body.h"
#include "archive/connection.h"

#include <optional>
#include <vector>

namespace devo_evo
{
/// Writes the generation's rows and those of its newcomers, and updates which genomes are kept.
/// @throw std::logic_error unless it is complete and follows the trial's last.
void insertGeneration(Connection& connection, const GenerationRecord& record, const ArchivedBody& body);

/// Numbers of the trials that have a generation, ascending.
std::vector<int64_t> findTrials(Connection& connection);

/// A trial's last generation and its champion; none if there is no generation.
std::optional<int64_t> findLastGeneration(Connection& connection, int64_t trial);
std::optional<int64_t> findLastChampion(Connection& connection, int64_t trial);

/// None if the trial has no generation.
std::optional<TrialExtent> findExtent(Connection& connection, int64_t trial);

/// None if there is no such generation.
std::optional<ArchivedSelection> findSelection(Connection& connection, int64_t trial, int64_t generation);

/// Ids in ranking order; empty if there is no such generation.
std::vector<int64_t> findSurvivors(Connection& connection, int64_t trial, int64_t generation);
}  // namespace devo_evo
