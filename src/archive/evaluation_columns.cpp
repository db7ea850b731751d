#include "archive/evaluation_columns.h"

#include "archive/bytes.h"

#include <cmath>

namespace devo_evo
{
namespace
{
void bindMeasure(Query& query, const Measure& measure, const Evaluation& evaluation)
{
  const double value = measure.get(evaluation);
  if (measure.whole)
  {
    query.with(std::isnan(value) ? std::nullopt : std::optional<int64_t>(static_cast<int64_t>(value)));
  }
  else
  {
    query.with(value + 0.0);  // SQLite does not keep the sign of zero: it is dropped here, where one can see it
  }
}

double readMeasure(Query& query, const Measure& measure)
{
  if (!measure.whole)
  {
    return query.real();
  }
  const auto value = query.optionalNatural();
  return value ? static_cast<double>(*value) : Evaluation::NONE;
}
}  // namespace

std::string evaluationColumns(const Body& body)
{
  std::string columns = "valid, fitness";
  for (const Measure& measure : body.measures())
  {
    columns += ", " + measure.name;
  }
  columns += ", state_hash";
  for (const Measure& measure : body.failureMeasures())
  {
    columns += ", " + measure.name;
  }
  return columns;
}

std::string evaluationMarks(const Body& body)
{
  std::string marks = "?, ?, ?";
  for (size_t i = 0; i < body.measures().size() + body.failureMeasures().size(); ++i)
  {
    marks += ", ?";
  }
  return marks;
}

void bindEvaluation(Query& query, const Body& body, const Evaluation& evaluation)
{
  query.with(evaluation.valid ? 1 : 0).with(evaluation.fitness + 0.0);
  for (const Measure& measure : body.measures())
  {
    bindMeasure(query, measure, evaluation);
  }
  query.with(evaluation.valid ? std::optional<Blob>(hashToBytes(evaluation.state_hash)) : std::nullopt);
  for (const Measure& measure : body.failureMeasures())
  {
    bindMeasure(query, measure, evaluation);
  }
}

Evaluation readEvaluation(Query& query, const Body& body)
{
  Evaluation evaluation;
  evaluation.valid = query.natural() != 0;
  evaluation.fitness = query.real();
  if (evaluation.valid == std::isnan(evaluation.fitness))
  {
    throw DamagedArchive("a valid individual has no fitness, or an invalid one has");
  }
  for (const Measure& measure : body.measures())
  {
    const double value = readMeasure(query, measure);
    if (evaluation.valid)
    {
      measure.set(evaluation, value);
    }
  }
  if (const auto state_hash = query.optionalBlob(sizeof(uint64_t)))
  {
    evaluation.state_hash = hashFromBytes(*state_hash);
  }
  for (const Measure& measure : body.failureMeasures())
  {
    const double value = readMeasure(query, measure);
    if (!evaluation.valid && !(measure.whole && std::isnan(value)))
    {
      measure.set(evaluation, value);
    }
  }
  return evaluation;
}
}  // namespace devo_evo
