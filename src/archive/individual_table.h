#pragma once

#include "archive/connection.h"

#include <optional>

namespace devo_evo
{
/// A row of the table individuals.
struct IndividualRow
{
  ArchivedIndividual archived;  ///< without genome
  Hash128 genome_hash;
};

/// @param phase_limit EvolutionSettings::phaseLimit(), to which the developmental window of control relates.
/// @pre the individual has been evaluated.
void insertIndividual(Connection& connection, const Individual& individual, double phase_limit);

/// @return none if there is no such individual.
std::optional<IndividualRow> findIndividual(Connection& connection, int64_t trial, int64_t id);

/// @throw DamagedArchive if there is no such individual, though others tell of it.
IndividualRow readIndividualRow(Connection& connection, int64_t trial, int64_t id);

std::optional<Evaluation> findEvaluationOf(Connection& connection, const Hash128& phenotype_hash);

/// The lowest id never given in a trial.
int64_t findNextId(Connection& connection, int64_t trial);
}  // namespace devo_evo
