#pragma once

#include "archive/archived_body.h"
#include "archive/connection.h"

#include <optional>
#include <set>
#include <vector>

namespace devo_evo
{
/// A genome's arrays as they are stored.
struct GenomeBlobs
{
  explicit GenomeBlobs(const Genome& genome);

  Blob morphology_initial;
  std::optional<Blob> morphology_final;  ///< none: as morphology_initial
  Blob control_initial;
  std::optional<Blob> control_final;  ///< none: as control_initial
  std::optional<Blob> mutation_rate;  ///< none: no part of the genome
};

/// The columns that hold a genome, in the order of GenomeBlobs: "size_gene_initial, ..., mutation_rate".
std::string genomeColumns(const GenomeLayout& layout);

/// The next five columns, in the order of GenomeBlobs. @throw DamagedArchive if an array does not fit the layout.
Genome readGenome(Query& query, const GenomeLayout& layout);

void insertGenome(Connection& connection, const Individual& individual, const GenomeLayout& layout);

/// @return none if it is not stored. @throw DamagedArchive if its arrays do not fit the layout.
std::optional<Genome> findGenome(Connection& connection, int64_t trial, int64_t id, const GenomeLayout& layout);

/// Deletes the genomes of the dead, and of those of their ancestors who have no living descendant any more.
void pruneGenomes(Connection& connection, int64_t trial, const std::vector<int64_t>& dead,
                  const std::set<int64_t>& living);

/// An individual with genome, after its nearest ancestors: as many as it takes to know the genome, or all.
/// The genome of a dead branch is made again from its parent's, since birth is a pure function; has_genome is false if
/// what was made does not have the hash it should have, as with another version of devo_evo.
/// @return oldest first; none if there is no such individual.
/// @throw DamagedArchive if a stored genome has another hash than at birth, or is none of these settings.
std::vector<ArchivedIndividual> readDescent(Connection& connection, const ExperimentSettings& settings,
                                            const ArchivedBody& body, int64_t trial, int64_t id, bool all_ancestors);
}  // namespace devo_evo
