#include "archive/individual_table.h"

#include "archive/evaluation_columns.h"

namespace devo_evo
{
namespace
{
ArchivedIndividual readRow(Query& query, const Body& body, int64_t trial)
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
  individual.evaluation = readEvaluation(query, body);
  if (individual.parent >= individual.id || individual.age > individual.generation)
  {
    throw DamagedArchive("individual " + individualName(trial, individual.id) +
                         " is older than its parent or its trial");
  }
  return archived;
}
}  // namespace

void insertIndividual(Connection& connection, const Individual& individual, const ArchivedBody& body)
{
  const DevelopmentalProgram& program = individual.genome.program;
  Query query = connection.query(
      "INSERT INTO individuals (trial, id, parent, generation, age, morphology_window, control_window, phenotype_hash, "
      "genome_hash, " +
          evaluationColumns(*body.body) + ") VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, " + evaluationMarks(*body.body) + ")",
      individual.trial, individual.id,
      individual.parent == Individual::NO_PARENT ? std::nullopt : std::optional<int64_t>(individual.parent),
      individual.generation, individual.age, morphologyWindow(program, body.layout),
      controlWindow(program, body.layout), phenotypeHash(program), genomeHash(individual.genome));
  bindEvaluation(query, *body.body, individual.evaluation.value());
  query.run();
}

std::optional<ArchivedIndividual> findIndividual(Connection& connection, const Body& body, int64_t trial, int64_t id)
{
  auto found = findIndividuals(connection, body, trial, id, 1);
  return found.empty() ? std::nullopt : std::optional<ArchivedIndividual>(std::move(found.front()));
}

ArchivedIndividual readIndividualRow(Connection& connection, const Body& body, int64_t trial, int64_t id)
{
  auto row = findIndividual(connection, body, trial, id);
  if (!row)
  {
    throw DamagedArchive("individual " + individualName(trial, id) + " is missing");
  }
  return *std::move(row);
}

std::vector<ArchivedIndividual> findIndividuals(Connection& connection, const Body& body, int64_t trial,
                                                int64_t first_id, int64_t count)
{
  Query query = connection.query(
      "SELECT id, parent, generation, age, morphology_window, control_window, phenotype_hash, genome_hash, " +
          evaluationColumns(body) + " FROM individuals WHERE trial = ? AND id BETWEEN ? AND ? ORDER BY id",
      trial, first_id, first_id + (count - 1));
  std::vector<ArchivedIndividual> found;
  while (query.next())
  {
    found.push_back(readRow(query, body, trial));
  }
  return found;
}

std::optional<Evaluation> findEvaluationOf(Connection& connection, const Body& body, const Hash128& phenotype_hash)
{
  Query query = connection.query(
      "SELECT " + evaluationColumns(body) + " FROM individuals WHERE phenotype_hash = ? LIMIT 1", phenotype_hash);
  return query.next() ? std::optional<Evaluation>(readEvaluation(query, body)) : std::nullopt;
}

int64_t findNextId(Connection& connection, int64_t trial)
{
  Query query = connection.query("SELECT max(id) FROM individuals WHERE trial = ?", trial);
  query.next();
  return query.optionalNatural().value_or(-1) + 1;
}
}  // namespace devo_evo
