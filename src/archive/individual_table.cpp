#include "archive/individual_table.h"

#include "archive/evaluation_columns.h"

namespace devo_evo
{
namespace
{
ArchivedIndividual readRow(Query& query, int64_t trial)
{
  ArchivedIndividual archived;
  Individual& individual = archived.individual;
  individual.trial = trial;
  individual.id = query.natural();
  individual.parent = query.optionalNatural().value_or(Individual::NO_PARENT);
  individual.generation = query.natural();
  individual.age = query.natural();
  archived.morphology_window = query.real();
  archived.control_window = query.real();
  archived.phenotype_hash = query.hash();
  archived.genome_hash = query.hash();
  individual.evaluation = readEvaluation(query);
  if (individual.parent >= individual.id || individual.age > individual.generation)
  {
    throw DamagedArchive("individual " + individualName(trial, individual.id) +
                         " is older than its parent or its trial");
  }
  return archived;
}
}  // namespace

void insertIndividual(Connection& connection, const Individual& individual, double phase_limit)
{
  const DevelopmentalProgram& program = individual.genome.program;
  const auto insert = [&](const auto&... values)
  {
    connection
        .query("INSERT INTO individuals (trial, id, parent, generation, age, " DEVO_EVO_EVALUATION_COLUMNS
               ", morphology_window, control_window, phenotype_hash, genome_hash) "
               "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
               individual.trial, individual.id,
               individual.parent == Individual::NO_PARENT ? std::nullopt : std::optional<int64_t>(individual.parent),
               individual.generation, individual.age, values..., morphologyWindow(program),
               controlWindow(program, phase_limit), phenotypeHash(program), genomeHash(individual.genome))
        .run();
  };
  std::apply(insert, evaluationValues(individual.evaluation.value()));
}

std::optional<ArchivedIndividual> findIndividual(Connection& connection, int64_t trial, int64_t id)
{
  auto found = findIndividuals(connection, trial, id, 1);
  return found.empty() ? std::nullopt : std::optional<ArchivedIndividual>(std::move(found.front()));
}

ArchivedIndividual readIndividualRow(Connection& connection, int64_t trial, int64_t id)
{
  auto row = findIndividual(connection, trial, id);
  if (!row)
  {
    throw DamagedArchive("individual " + individualName(trial, id) + " is missing");
  }
  return *std::move(row);
}

std::vector<ArchivedIndividual> findIndividuals(Connection& connection, int64_t trial, int64_t first_id, int64_t count)
{
  Query query = connection.query(
      "SELECT id, parent, generation, age, morphology_window, control_window, phenotype_hash, "
      "genome_hash, " DEVO_EVO_EVALUATION_COLUMNS
      " FROM individuals WHERE trial = ? AND id BETWEEN ? AND ? ORDER BY id",
      trial, first_id, first_id + (count - 1));
  std::vector<ArchivedIndividual> found;
  while (query.next())
  {
    found.push_back(readRow(query, trial));
  }
  return found;
}

std::optional<Evaluation> findEvaluationOf(Connection& connection, const Hash128& phenotype_hash)
{
  Query query = connection.query(
      "SELECT " DEVO_EVO_EVALUATION_COLUMNS " FROM individuals WHERE phenotype_hash = ? LIMIT 1", phenotype_hash);
  return query.next() ? std::optional<Evaluation>(readEvaluation(query)) : std::nullopt;
}

int64_t findNextId(Connection& connection, int64_t trial)
{
  Query query = connection.query("SELECT max(id) FROM individuals WHERE trial = ?", trial);
  query.next();
  return query.optionalNatural().value_or(-1) + 1;
}
}  // namespace devo_evo
