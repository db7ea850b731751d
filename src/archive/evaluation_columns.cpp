#include "archive/evaluation_columns.h"

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

}  // namespace

EvaluationValues evaluationValues(const Evaluation& evaluation)
{
  const auto& divergence = evaluation.divergence;
  return { evaluation.valid ? 1 : 0,
           withoutNegativeZero(evaluation.fitness),
           withoutNegativeZero(evaluation.displacement_y_voxels),
           withoutNegativeZero(evaluation.displacement_xy_voxels),
           withoutNegativeZero(evaluation.first_top_contact_since_birth_s),
           withoutNegativeZero(evaluation.fell_over_since_birth_s),
           withoutNegativeZero(evaluation.turns),
           withoutNegativeZero(evaluation.airborne_fraction),
           evaluation.valid ? std::optional<Blob>(hashToBytes(evaluation.state_hash)) : std::nullopt,
           divergence ? std::optional<int64_t>(divergence->step) : std::nullopt,
           divergence ? std::optional<int64_t>(divergence->bond) : std::nullopt,
           divergence ? std::optional<double>(divergence->strain) : std::nullopt };
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
}  // namespace devo_evo
