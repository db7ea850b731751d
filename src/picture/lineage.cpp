#include "devo_evo/picture/lineage.h"

#include "devo_evo/experiment/report_text.h"
#include "devo_evo/soft_body/text.h"

#include <algorithm>
#include <cmath>

namespace devo_evo
{
namespace
{
double fitnessOf(const ArchivedIndividual& archived)
{
  const std::optional<Evaluation>& evaluation = archived.individual.evaluation;
  return evaluation && evaluation->valid ? evaluation->fitness : -std::numeric_limits<double>::infinity();
}

constexpr double ROLLER_TURNS = 1.0;        // full turns from which on a robot is said to roll
constexpr double SHUFFLER_DISTANCE = 1.0;   // body lengths, below which it is said to shuffle
constexpr double AIRBORNE_FRACTION = 0.05;  // of life, from which on it is said to leap
}  // namespace

Lineage readLineage(const Archive& archive, std::optional<int64_t> trial, std::optional<int64_t> id)
{
  if (!trial)
  {
    const std::optional<ArchivedIndividual> best = bestChampion(archive);
    if (!best)
    {
      throw InvalidInput("there is no lineage: no trial has a valid champion yet");
    }
    trial = best->individual.trial;
    id = best->individual.id;
  }
  return { archive.settings(), archive.readLineage(*trial, id ? *id : archive.championOf(*trial)) };
}

std::vector<size_t> evenlySpaced(size_t lineage_size, int64_t count)
{
  if (count < 0 || (count == 1 && lineage_size > 1))
  {
    throw InvalidInput("count is " + toText(count) + "; it must be 0 for all, or at least 2: founder and champion");
  }
  const size_t chosen = count == 0 ? lineage_size : std::min(lineage_size, static_cast<size_t>(count));
  std::vector<size_t> positions;
  for (size_t i = 0; i < chosen; ++i)
  {
    positions.push_back(chosen == 1 ? 0 : (i * (lineage_size - 1) + (chosen - 1) / 2) / (chosen - 1));
  }
  return positions;
}

std::vector<size_t> stepsOfProgress(const Lineage& lineage, int64_t count)
{
  const size_t last = lineage.individuals.size() - 1;
  if (count < 2)
  {
    throw InvalidInput("count is " + toText(count) + "; it must be at least 2: founder and champion");
  }
  const double from = std::max(0.0, fitnessOf(lineage.individuals.front()));
  double to = from;
  for (const ArchivedIndividual& ancestor : lineage.individuals)
  {
    to = std::max(to, fitnessOf(ancestor));
  }
  std::vector<size_t> positions = { 0 };
  for (int64_t step = 1; step < count - 1; ++step)
  {
    const double goal = from + (to - from) * static_cast<double>(step) / static_cast<double>(count - 1);
    const auto first = std::find_if(lineage.individuals.begin(), lineage.individuals.end(),
                                    [&](const ArchivedIndividual& a) { return fitnessOf(a) >= goal; });
    const auto position = static_cast<size_t>(first - lineage.individuals.begin());
    if (position > positions.back() && position < last)
    {
      positions.push_back(position);
    }
  }
  if (last > 0)
  {
    positions.push_back(last);
  }
  return positions;
}

std::string behaviourText(const Evaluation& evaluation, const Body& body)
{
  if (!evaluation.valid)
  {
    return "its simulation diverges";
  }
  const std::string fall = evaluation.fell_over_since_birth_s
                               ? fixedText(*evaluation.fell_over_since_birth_s, 1) + " s after birth"
                               : std::string();
  if (std::abs(evaluation.turns) >= ROLLER_TURNS)
  {
    return "rolls " + fixedText(std::abs(evaluation.turns), 0) +
           (std::abs(evaluation.turns) < 1.5 ? " time" : " times") +
           (fall.empty() ? "" : ", first on its back " + fall);
  }
  const double travelled = body.meanVelocity(evaluation) * body.lifetime();
  const std::string gait = travelled < SHUFFLER_DISTANCE                       ? "shuffles"
                           : evaluation.airborne_fraction >= AIRBORNE_FRACTION ? "gallops"
                                                                               : "walks";
  return gait + (fall.empty() ? "" : " and falls over " + fall);
}
}  // namespace devo_evo
