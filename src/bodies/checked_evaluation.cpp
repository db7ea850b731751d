#include "bodies/checked_evaluation.h"

#include "devo_evo/soft_body/text.h"
#include "soft_body/check_ranges.h"

#include <cmath>

namespace devo_evo
{
namespace
{
void requireFinite(const std::string& name, double value)
{
  if (!std::isfinite(value))
  {
    throw InvalidInput(name + " is " + toText(value) + "; it must be finite");
  }
}

void checkMeasure(const Measure& measure, const Evaluation& evaluation)
{
  const double value = measure.get(evaluation);
  if (std::isnan(value) && measure.may_lack)
  {
    return;
  }
  if (std::isinf(measure.minimum) && std::isinf(measure.maximum))
  {
    requireFinite(measure.name, value);
  }
  else
  {
    requireWithin(measure.name, value, measure.minimum, measure.maximum);
  }
}

void checkVelocities(const Body& body, const Evaluation& evaluation)
{
  const std::vector<double>& velocities = evaluation.velocity_body_lengths_per_s;
  if (velocities.empty())
  {
    return;
  }
  const double windows = body.lifetime() / Evaluation::VELOCITY_WINDOW;
  requireWithin("the number of velocity windows", static_cast<double>(velocities.size()), std::floor(windows),
                std::ceil(windows));
  for (const double velocity : velocities)
  {
    requireFinite("velocity", velocity);
  }
}
}  // namespace

void checkEvaluation(const Body& body, const Evaluation& evaluation)
{
  if (evaluation.valid)
  {
    requireFinite("fitness", evaluation.fitness);
    for (const Measure& measure : body.measures())
    {
      checkMeasure(measure, evaluation);
    }
    checkVelocities(body, evaluation);
    if (evaluation.divergence)
    {
      throw InvalidInput("a valid evaluation has a divergence");
    }
    return;
  }
  bool measured = !std::isnan(evaluation.fitness);
  for (const Measure& measure : body.measures())
  {
    measured = measured || !std::isnan(measure.get(evaluation));
  }
  if (measured || !evaluation.velocity_body_lengths_per_s.empty() || evaluation.state_hash != 0)
  {
    throw InvalidInput("an invalid evaluation has measures, velocities or a hash");
  }
  for (const Measure& measure : body.failureMeasures())
  {
    checkMeasure(measure, evaluation);
  }
}
}  // namespace devo_evo
