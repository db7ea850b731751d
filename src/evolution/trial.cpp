#include "devo_evo/evolution/trial.h"

#include "devo_evo/evolution/selection.h"
#include "devo_evo/soft_body/text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace devo_evo
{
namespace
{
Candidate candidateOf(const Individual& individual)
{
  const Evaluation& evaluation = *individual.evaluation;
  return { individual.id, individual.age, evaluation.valid, evaluation.fitness };
}

bool sameOutcome(const Evaluation& a, const Evaluation& b)
{
  return a.valid == b.valid && a.state_hash == b.state_hash && (!a.valid || a.fitness == b.fitness);
}

/// The middle one, or the mean of the middle two; NaN if there is none.
double median(std::vector<double> values)
{
  if (values.empty())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  std::sort(values.begin(), values.end());
  const size_t upper_middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[upper_middle] : 0.5 * (values[upper_middle - 1] + values[upper_middle]);
}

/// 0 to count - 1 in an order drawn uniformly (Fisher and Yates' shuffle, from the last place down).
std::vector<size_t> shuffledOrder(size_t count, RandomStream& random)
{
  std::vector<size_t> order(count);
  for (size_t i = 0; i < count; ++i)
  {
    order[i] = i;
  }
  for (size_t last = count; last-- > 1;)
  {
    std::swap(order[last], order[random.below(last + 1)]);
  }
  return order;
}

/// What the record says about the survivors, in ranking order.
void describeSurvivors(const std::vector<Individual>& survivors, GenerationRecord& record)
{
  std::vector<double> fitnesses;
  for (const Individual& survivor : survivors)
  {
    record.survivors.push_back(survivor.id);
    if (survivor.evaluation->valid)
    {
      fitnesses.push_back(survivor.evaluation->fitness);
    }
  }
  // Under any selection the fittest comes first: nobody dominates it but its equals.
  record.champion = record.survivors.front();
  record.best_fitness = fitnesses.empty() ? std::numeric_limits<double>::quiet_NaN() : fitnesses.front();
  record.median_fitness = median(fitnesses);
}
}  // namespace

Trial::Trial(const EvolutionSettings& settings, const Body& body, int64_t number)
  : settings_(settings), layout_(body.layout(settings)), number_(number)
{
  settings.validate();
  for (int founder = 0; founder < settings.population; ++founder)
  {
    addNewborn(nullptr);
  }
}

Trial::Trial(const EvolutionSettings& settings, const Body& body, int64_t number, int64_t generation,
             std::vector<Individual> survivors, int64_t next_id)
  : settings_(settings)
  , layout_(body.layout(settings))
  , number_(number)
  , generation_(generation)
  , next_id_(next_id)
  , selected_(true)
  , individuals_(std::move(survivors))
{
  settings.validate();
  if (individuals_.empty())
  {
    throw std::invalid_argument("a trial cannot go on without survivors");
  }
  for (const Individual& individual : individuals_)
  {
    if (!individual.evaluation || individual.id >= next_id)
    {
      throw std::invalid_argument("survivor " + individualName(number, individual.id) +
                                  " has no evaluation, or an id that is still to be given");
    }
  }
}

void Trial::addNewborn(const Individual* parent)
{
  Individual newborn;
  newborn.trial = number_;
  newborn.id = next_id_++;
  newborn.parent = parent ? parent->id : Individual::NO_PARENT;
  newborn.generation = generation_;
  newborn.age = parent ? parent->age : 0;
  newborn.genome = bornGenome(settings_, layout_, number_, generation_, newborn.id, parent ? &parent->genome : nullptr);
  individuals_.push_back(std::move(newborn));
}

size_t Trial::indexOf(int64_t id) const
{
  for (size_t i = 0; i < individuals_.size(); ++i)
  {
    if (individuals_[i].id == id)
    {
      return i;
    }
  }
  throw std::out_of_range("individual " + individualName(number_, id) + " is not alive in generation " +
                          toText(generation_));
}

std::vector<int64_t> Trial::awaiting() const
{
  // Survivors have been evaluated, and newcomers stand in the order of their ids.
  std::vector<int64_t> ids;
  for (const Individual& individual : individuals_)
  {
    if (!individual.evaluation)
    {
      ids.push_back(individual.id);
    }
  }
  return ids;
}

void Trial::setEvaluation(int64_t id, const Evaluation& evaluation)
{
  std::optional<Evaluation>& known = individuals_[indexOf(id)].evaluation;
  if (evaluation.valid && !std::isfinite(evaluation.fitness))
  {
    throw InvalidInput("the evaluation of individual " + individualName(number_, id) +
                       " is valid, but its fitness is " + toText(evaluation.fitness));
  }
  if (!known)
  {
    known = evaluation;
  }
  else if (!sameOutcome(*known, evaluation))
  {
    throw std::logic_error("individual " + individualName(number_, id) + " has another evaluation already");
  }
}

GenerationRecord Trial::select()
{
  if (selected_ || !awaiting().empty())
  {
    throw std::logic_error(selected_ ? "the generation has been selected already"
                                     : "individuals still await their evaluation");
  }
  GenerationRecord record;
  record.trial = number_;
  record.generation = generation_;
  std::vector<Candidate> candidates;
  for (const Individual& individual : individuals_)
  {
    candidates.push_back(candidateOf(individual));
    if (individual.generation == generation_)
    {
      record.newcomers.push_back(individual);
    }
  }

  RandomStream random(settings_.seed, layout_.arm, number_, generation_, 0, RandomPurpose::SURVIVOR_DRAW);
  std::vector<Individual> survivors;
  for (const size_t index :
       selectSurvivors(settings_.selection, candidates, static_cast<size_t>(settings_.population), random))
  {
    survivors.push_back(std::move(individuals_[index]));
  }
  individuals_ = std::move(survivors);
  selected_ = true;
  describeSurvivors(individuals_, record);
  return record;
}

void Trial::breed()
{
  if (!selected_)
  {
    throw std::logic_error("a generation must be selected before the next is bred");
  }
  ++generation_;
  selected_ = false;
  for (Individual& survivor : individuals_)
  {
    ++survivor.age;
  }
  RandomStream random(settings_.seed, layout_.arm, number_, generation_, 0, RandomPurpose::PARENT_ORDER);
  const size_t survivor_count = individuals_.size();
  individuals_.reserve(2 * survivor_count + static_cast<size_t>(settings_.random_injections));
  const bool have_children = settings_.selection != Selection::RANDOM_SEARCH;
  for (const size_t parent : shuffledOrder(survivor_count, random))
  {
    addNewborn(have_children ? &individuals_[parent] : nullptr);
  }
  for (int injection = 0; injection < settings_.random_injections; ++injection)
  {
    addNewborn(nullptr);
  }
}
}  // namespace devo_evo
