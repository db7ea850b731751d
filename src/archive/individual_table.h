#pragma once

#include "archive/archived_body.h"
#include "archive/connection.h"

#include <optional>

namespace devo_evo
{
/// @pre the individual has been evaluated.
void insertIndividual(Connection& connection, const Individual& individual, const ArchivedBody& body);

/// Without genome. @return none if there is no such individual.
std::optional<ArchivedIndividual> findIndividual(Connection& connection, const Body& body, int64_t trial, int64_t id);

/// @throw DamagedArchive if there is no such individual, though others tell of it.
ArchivedIndividual readIndividualRow(Connection& connection, const Body& body, int64_t trial, int64_t id);

/// Those whose ids lie in [first_id, first_id + count), ascending, without genomes.
std::vector<ArchivedIndividual> findIndividuals(Connection& connection, const Body& body, int64_t trial,
                                                int64_t first_id, int64_t count);

std::optional<Evaluation> findEvaluationOf(Connection& connection, const Body& body, const Hash128& phenotype_hash);

/// The lowest id never given in a trial.
int64_t findNextId(Connection& connection, int64_t trial);
}  // namespace devo_evo
