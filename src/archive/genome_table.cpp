#include "archive/genome_table.h"

#include "archive/bytes.h"
#include "archive/individual_table.h"

#include <algorithm>

namespace devo_evo
{
namespace
{
/// The array as it is stored, or none if it equals the one it develops from.
std::optional<Blob> unlessEqual(const std::vector<double>& final_values, const Blob& initial_values)
{
  Blob bytes = numbersToBytes(final_values);
  return bytes == initial_values ? std::nullopt : std::optional<Blob>(std::move(bytes));
}

/// What a lineage knows of one individual before genomes are made again.
struct Ancestor
{
  ArchivedIndividual archived;  ///< without genome
  std::optional<Genome> stored;
};

/// From the individual to its oldest ancestor, or to the first whose genome is stored.
std::vector<Ancestor> collectAncestors(Connection& connection, int voxel_count, int64_t trial, int64_t id,
                                       bool all_ancestors)
{
  std::vector<Ancestor> ancestors;
  std::optional<ArchivedIndividual> row = findIndividual(connection, trial, id);
  while (row)
  {
    ancestors.push_back({ *row, findGenome(connection, trial, row->individual.id, voxel_count) });
    const int64_t parent = row->individual.parent;
    if (parent == Individual::NO_PARENT || (ancestors.back().stored && !all_ancestors))
    {
      break;
    }
    row = readIndividualRow(connection, trial, parent);
  }
  return ancestors;
}

/// Gives an individual the genome that is stored, or else the one that its birth gives again.
/// @param parent nullptr if it has none; without genome if that is not known.
void setGenome(ArchivedIndividual& archived, const Ancestor& ancestor, const ArchivedIndividual* parent,
               const EvolutionSettings& settings, const Lattice& lattice)
{
  Individual& individual = archived.individual;
  if (ancestor.stored)
  {
    individual.genome = *ancestor.stored;
  }
  else if (!parent || parent->has_genome)
  {
    individual.genome = bornGenome(settings, lattice, individual.trial, individual.generation, individual.id,
                                   parent ? &parent->individual.genome : nullptr);
  }
  archived.has_genome = genomeHash(individual.genome) == archived.genome_hash;
  if (!archived.has_genome && ancestor.stored)
  {
    throw DamagedArchive("the genome of individual " + individualName(individual.trial, individual.id) +
                         " does not have the hash it had when it was born");
  }
  if (!archived.has_genome)
  {
    individual.genome = Genome();
  }
}

/// Descendants are made again from stored genomes, which therefore have to fit the settings.
void checkGenome(const Individual& individual, const ExperimentSettings& settings)
{
  try
  {
    validate(individual.genome, settings.evolution, settings.body);
  }
  catch (const InvalidInput& error)
  {
    throw DamagedArchive("individual " + individualName(individual.trial, individual.id) + ": " + error.what());
  }
}
}  // namespace

GenomeBlobs::GenomeBlobs(const Genome& genome)
  : size_gene_initial(numbersToBytes(genome.program.size_gene_initial))
  , size_gene_final(unlessEqual(genome.program.size_gene_final, size_gene_initial))
  , phase_initial(numbersToBytes(genome.program.phase_initial))
  , phase_final(unlessEqual(genome.program.phase_final, phase_initial))
{
  if (!genome.mutation_rate.empty())
  {
    mutation_rate = numbersToBytes(genome.mutation_rate);
  }
}

Genome readGenome(Query& query, int voxel_count)
{
  const size_t size = sizeof(double) * static_cast<size_t>(voxel_count);
  Genome genome;
  DevelopmentalProgram& program = genome.program;
  const Blob size_gene_initial = query.blob(size);
  program.size_gene_initial = numbersFromBytes(size_gene_initial);
  program.size_gene_final = numbersFromBytes(query.optionalBlob(size).value_or(size_gene_initial));
  const Blob phase_initial = query.blob(size);
  program.phase_initial = numbersFromBytes(phase_initial);
  program.phase_final = numbersFromBytes(query.optionalBlob(size).value_or(phase_initial));
  genome.mutation_rate = numbersFromBytes(query.optionalBlob(size).value_or(Blob()));
  return genome;
}

void insertGenome(Connection& connection, const Individual& individual)
{
  const GenomeBlobs blobs(individual.genome);
  connection
      .query(
          "INSERT INTO genomes (trial, id, parent, size_gene_initial, size_gene_final, phase_initial, phase_final, "
          "mutation_rate) VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
          individual.trial, individual.id,
          individual.parent == Individual::NO_PARENT ? std::nullopt : std::optional<int64_t>(individual.parent),
          blobs.size_gene_initial, blobs.size_gene_final, blobs.phase_initial, blobs.phase_final, blobs.mutation_rate)
      .run();
}

std::optional<Genome> findGenome(Connection& connection, int64_t trial, int64_t id, int voxel_count)
{
  Query query = connection.query(
      "SELECT size_gene_initial, size_gene_final, phase_initial, phase_final, mutation_rate "
      "FROM genomes WHERE trial = ? AND id = ?",
      trial, id);
  return query.next() ? std::optional<Genome>(readGenome(query, voxel_count)) : std::nullopt;
}

void pruneGenomes(Connection& connection, int64_t trial, const std::vector<int64_t>& dead,
                  const std::set<int64_t>& living)
{
  for (std::optional<int64_t> id : dead)
  {
    while (id && living.count(*id) == 0 &&
           !connection.query("SELECT 1 FROM genomes WHERE trial = ? AND parent = ? LIMIT 1", trial, *id).next())
    {
      std::optional<int64_t> parent;
      {
        Query query = connection.query("SELECT parent FROM genomes WHERE trial = ? AND id = ?", trial, *id);
        parent = query.next() ? query.optionalNatural() : std::nullopt;
      }
      connection.query("DELETE FROM genomes WHERE trial = ? AND id = ?", trial, *id).run();
      id = parent;
    }
  }
}

std::vector<ArchivedIndividual> readDescent(Connection& connection, const ExperimentSettings& settings,
                                            const Lattice& lattice, int64_t trial, int64_t id, bool all_ancestors)
{
  std::vector<Ancestor> ancestors = collectAncestors(connection, lattice.voxelCount(), trial, id, all_ancestors);
  std::reverse(ancestors.begin(), ancestors.end());
  std::vector<ArchivedIndividual> descent;
  descent.reserve(ancestors.size());
  for (const Ancestor& ancestor : ancestors)
  {
    const ArchivedIndividual* parent = descent.empty() ? nullptr : &descent.back();
    ArchivedIndividual archived = ancestor.archived;
    setGenome(archived, ancestor, parent, settings.evolution, lattice);
    if (ancestor.stored)
    {
      checkGenome(archived.individual, settings);
    }
    descent.push_back(std::move(archived));
  }
  return descent;
}
}  // namespace devo_evo
