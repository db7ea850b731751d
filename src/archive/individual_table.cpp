#include "archive/individual_table.h"

#include "archive/bytes.h"

#include <cmath>

namespace devo_evo
{
namespace
{
/// SQLite does not keep the sign of zero: it is dropped here, where one can see it.
double withoutNegativeZero(double value)
{
  return value + 0.0;
}

std::optional<double> withoutNegativeZero(const std::optional<double>& value)
{
  return value ? std::optional<double>(withoutNegativeZero(*value)) : std::nullopt;
}

Evaluation readEvaluation(Query& query)
{
  Evaluation evaluation;
  evaluation.valid = query.natural() != 0;
  evaluation.fitness = query.real();
  if (evaluation.valid == std::isnan(evaluation.fitness))
  {
    throw DamagedArchive("a valid individual has no fitness, or an invalid one has");
  }
  evaluation.displacement_y_voxels = query.real();
  evaluation.displacement_xy_voxels = query.real();
  evaluation.first_top_contact_since_birth_s = query.optionalReal();
  evaluation.fell_over_since_birth_s = query.optionalReal();
  evaluation.turns = query.real();
  evaluation.airborne_fraction = query.real();
  if (const auto state_hash = query.optionalBlob(sizeof(uint64_t)))
  {
    evaluation.state_hash = hashFromBytes(*state_hash);
  }
  const auto step = query.optionalNatural();
  const auto bond = query.optionalNatural();
  const double strain = query.real();
  if (!evaluation.valid)
  {
    evaluation.divergence = Divergence{ step.value_or(0), static_cast<int>(bond.value_or(0)), strain };
  }
  return evaluation;
}
}  // namespace

void insertIndividual(Connection& connection, const Individual& individual, double phase_limit)
{
  const Evaluation& evaluation = individual.evaluation.value();
  const auto& divergence = evaluation.divergence;
  const DevelopmentalProgram& program = individual.genome.program;
  connection
      .query(
          "INSERT INTO individuals (trial, id, parent, generation, age, valid, fitness, displacement_y_voxels, "
          "displacement_xy_voxels, first_top_contact_since_birth_s, fell_over_since_birth_s, turns, "
          "airborne_fraction, state_hash, divergence_step, divergence_bond, divergence_strain, morphology_window, "
          "control_window, phenotype_hash, genome_hash) "
          "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
          individual.trial, individual.id,
          individual.parent == Individual::NO_PARENT ? std::nullopt : std::optional<int64_t>(individual.parent),
          individual.generation, individual.age, evaluation.valid ? 1 : 0, withoutNegativeZero(evaluation.fitness),
          withoutNegativeZero(evaluation.displacement_y_voxels), withoutNegativeZero(evaluation.displacement_xy_voxels),
          withoutNegativeZero(evaluation.first_top_contact_since_birth_s),
          withoutNegativeZero(evaluation.fell_over_since_birth_s), withoutNegativeZero(evaluation.turns),
          withoutNegativeZero(evaluation.airborne_fraction),
          evaluation.valid ? std::optional<Blob>(hashToBytes(evaluation.state_hash)) : std::nullopt,
          divergence ? std::optional<int64_t>(divergence->step) : std::nullopt,
          divergence ? std::optional<int64_t>(divergence->bond) : std::nullopt,
          divergence ? std::optional<double>(divergence->strain) : std::nullopt, morphologyWindow(program),
          controlWindow(program, phase_limit), phenotypeHash(program), genomeHash(individual.genome))
      .run();
}

std::optional<IndividualRow> findIndividual(Connection& connection, int64_t trial, int64_t id)
{
  Query query = connection.query(
      "SELECT parent, generation, age, morphology_window, control_window, genome_hash, valid, fitness, "
      "displacement_y_voxels, displacement_xy_voxels, first_top_contact_since_birth_s, fell_over_since_birth_s, turns, "
      "airborne_fraction, state_hash, divergence_step, divergence_bond, divergence_strain "
      "FROM individuals WHERE trial = ? AND id = ?",
      trial, id);
  if (!query.next())
  {
    return std::nullopt;
  }
  IndividualRow row;
  Individual& individual = row.archived.individual;
  individual.trial = trial;
  individual.id = id;
  individual.parent = query.optionalNatural().value_or(Individual::NO_PARENT);
  individual.generation = query.natural();
  individual.age = query.natural();
  row.archived.morphology_window = query.real();
  row.archived.control_window = query.real();
  row.genome_hash = query.hash();
  individual.evaluation = readEvaluation(query);
  if (individual.parent >= id || individual.age > individual.generation)
  {
    throw DamagedArchive("individual " + individualName(trial, id) + " is older than its parent or its trial");
  }
  return row;
}

IndividualRow readIndividualRow(Connection& connection, int64_t trial, int64_t id)
{
  auto row = findIndividual(connection, trial, id);
  if (!row)
  {
    throw DamagedArchive("individual " + individualName(trial, id) + " is missing");
  }
  return *std::move(row);
}

std::optional<Evaluation> findEvaluationOf(Connection& connection, const Hash128& phenotype_hash)
{
  Query query = connection.query(
      "SELECT valid, fitness, displacement_y_voxels, displacement_xy_voxels, first_top_contact_since_birth_s, "
      "fell_over_since_birth_s, turns, airborne_fraction, state_hash, divergence_step, divergence_bond, "
      "divergence_strain FROM individuals WHERE phenotype_hash = ? LIMIT 1",
      phenotype_hash);
  return query.next() ? std::optional<Evaluation>(readEvaluation(query)) : std::nullopt;
}

int64_t findNextId(Connection& connection, int64_t trial)
{
  Query query = connection.query("SELECT max(id) FROM individuals WHERE trial = ?", trial);
  query.next();
  return query.optionalNatural().value_or(-1) + 1;
}
}  // namespace devo_evo
