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
std::vector<Ancestor> collectAncestors(Connection& connection, const ArchivedBody& body, int64_t trial, int64_t id,
                                       bool all_ancestors)
{
  std::vector<Ancestor> ancestors;
  std::optional<ArchivedIndividual> row = findIndividual(connection, *body.body, trial, id);
  while (row)
  {
    ancestors.push_back({ *row, findGenome(connection, trial, row->individual.id, body.layout) });
    const int64_t parent = row->individual.parent;
    if (parent == Individual::NO_PARENT || (ancestors.back().stored && !all_ancestors))
    {
      break;
    }
    row = readIndividualRow(connection, *body.body, trial, parent);
  }
  return ancestors;
}

/// Gives an individual the genome that is stored, or else the one that its birth gives again.
/// @param parent nullptr if it has none; without genome if that is not known.
void setGenome(ArchivedIndividual& archived, const Ancestor& ancestor, const ArchivedIndividual* parent,
               const EvolutionSettings& settings, const GenomeLayout& layout)
{
  Individual& individual = archived.individual;
  if (ancestor.stored)
  {
    individual.genome = *ancestor.stored;
  }
  else if (!parent || parent->has_genome)
  {
    individual.genome = bornGenome(settings, layout, individual.trial, individual.generation, individual.id,
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
void checkGenome(const Individual& individual, const EvolutionSettings& settings, const GenomeLayout& layout)
{
  try
  {
    validate(individual.genome, settings, layout);
  }
  catch (const InvalidInput& error)
  {
    throw DamagedArchive("individual " + individualName(individual.trial, individual.id) + ": " + error.what());
  }
}
}  // namespace

GenomeBlobs::GenomeBlobs(const Genome& genome)
  : morphology_initial(numbersToBytes(genome.program.morphology_initial))
  , morphology_final(unlessEqual(genome.program.morphology_final, morphology_initial))
  , control_initial(numbersToBytes(genome.program.control_initial))
  , control_final(unlessEqual(genome.program.control_final, control_initial))
{
  if (!genome.mutation_rate.empty())
  {
    mutation_rate = numbersToBytes(genome.mutation_rate);
  }
}

std::string genomeColumns(const GenomeLayout& layout)
{
  const GenomePart& morphology = layout.morphology;
  const GenomePart& control = layout.control;
  return morphology.initialName() + ", " + morphology.finalName() + ", " + control.initialName() + ", " +
         control.finalName() + ", mutation_rate";
}

Genome readGenome(Query& query, const GenomeLayout& layout)
{
  const size_t morphology_size = sizeof(double) * layout.morphology.size;
  const size_t control_size = sizeof(double) * layout.control.size;
  Genome genome;
  DevelopmentalProgram& program = genome.program;
  const Blob morphology_initial = query.blob(morphology_size);
  program.morphology_initial = numbersFromBytes(morphology_initial);
  program.morphology_final = numbersFromBytes(query.optionalBlob(morphology_size).value_or(morphology_initial));
  const Blob control_initial = query.blob(control_size);
  program.control_initial = numbersFromBytes(control_initial);
  program.control_final = numbersFromBytes(query.optionalBlob(control_size).value_or(control_initial));
  genome.mutation_rate = numbersFromBytes(query.optionalBlob(morphology_size).value_or(Blob()));
  return genome;
}

void insertGenome(Connection& connection, const Individual& individual, const GenomeLayout& layout)
{
  const GenomeBlobs blobs(individual.genome);
  connection
      .query("INSERT INTO genomes (trial, id, parent, " + genomeColumns(layout) + ") VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
             individual.trial, individual.id,
             individual.parent == Individual::NO_PARENT ? std::nullopt : std::optional<int64_t>(individual.parent),
             blobs.morphology_initial, blobs.morphology_final, blobs.control_initial, blobs.control_final,
             blobs.mutation_rate)
      .run();
}

std::optional<Genome> findGenome(Connection& connection, int64_t trial, int64_t id, const GenomeLayout& layout)
{
  Query query =
      connection.query("SELECT " + genomeColumns(layout) + " FROM genomes WHERE trial = ? AND id = ?", trial, id);
  return query.next() ? std::optional<Genome>(readGenome(query, layout)) : std::nullopt;
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
                                            const ArchivedBody& body, int64_t trial, int64_t id, bool all_ancestors)
{
  std::vector<Ancestor> ancestors = collectAncestors(connection, body, trial, id, all_ancestors);
  std::reverse(ancestors.begin(), ancestors.end());
  std::vector<ArchivedIndividual> descent;
  descent.reserve(ancestors.size());
  for (const Ancestor& ancestor : ancestors)
  {
    const ArchivedIndividual* parent = descent.empty() ? nullptr : &descent.back();
    ArchivedIndividual archived = ancestor.archived;
    setGenome(archived, ancestor, parent, settings.evolution, body.layout);
    if (ancestor.stored)
    {
      checkGenome(archived.individual, settings.evolution, body.layout);
    }
    descent.push_back(std::move(archived));
  }
  return descent;
}
}  // namespace devo_evo
