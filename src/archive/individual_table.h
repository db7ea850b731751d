#pragma once

#include "archive/connection.h"

#include <optional>

namespace devo_evo
{
/// @param phase_limit EvolutionSettings::phaseLimit(), to which the developmental window of control relates.
/// @pre the individual has been evaluated.
void insertIndividual(Connection& connection, const Individual& individual, double phase_limit);

/// Without genome. @return none if there is no such individual.
std::optional<ArchivedIndividual> findIndividual(Connection& connection, int64_t trial, int64_t id);

/// @throw DamagedArchive if there is no such individual, though others tell of it.
ArchivedIndividual readIndividualRow(Connection& connection, int64_t trial, int64_t id);

/// Those whose ids lie in [first_id, first_id + count), ascending, without genomes.
std::vector<ArchivedIndividual> findIndividuals(Connection& connection, int64_t trial, int64_t first_id, int64_t count);

std::optional<Evaluation> findEvaluationOf(Connection& connection, const Hash128& phenotype_hash);

/// The lowest id never given in a trial.
int64_t findNextId(Connection& connection, int64_t trial);
}  // namespace devo_evo
