#include "devo_evo/evolution/selection.h"
#include "devo_evo/evolution/trial.h"
#include "evolution/settings_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace devo_evo;

namespace
{
Candidate valid(int64_t id, int64_t age, double fitness)
{
  return { id, age, true, fitness };
}

/// Ids of those who survive, in their order.
std::vector<int64_t> survivorsOf(Selection selection, const std::vector<Candidate>& candidates, size_t population,
                                 int64_t generation = 0)
{
  RandomStream random(1, "arm", 0, generation, 0, RandomPurpose::SURVIVOR_DRAW);
  std::vector<int64_t> ids;
  for (const size_t index : selectSurvivors(selection, candidates, population, random))
  {
    ids.push_back(candidates[index].id);
  }
  return ids;
}

EvolutionSettings baseline(Selection selection)
{
  EvolutionSettings settings = settingsOf(Treatment::EVO_DEVO, Profile::PAPER);
  settings.selection = selection;
  settings.population = 6;
  return settings;
}

/// The fitness of a robot is its first size gene.
GenerationRecord evaluateAndSelect(Trial& trial)
{
  for (const int64_t id : trial.awaiting())
  {
    Evaluation evaluation;
    evaluation.valid = true;
    evaluation.fitness = trial.individual(id).genome.program.morphology_initial[0];
    trial.setEvaluation(id, evaluation);
  }
  return trial.select();
}
}  // namespace

TEST(RandomSearch, keepsTheFittestWhateverTheirAge)
{
  const std::vector<Candidate> candidates = {
    valid(0, 9, 3.0), valid(1, 0, 1.0), valid(2, 9, 2.0), { 3, 0, false, NAN }, valid(4, 9, 3.0)
  };
  EXPECT_EQ((std::vector<int64_t>{ 4, 0 }), survivorsOf(Selection::RANDOM_SEARCH, candidates, 2));
  EXPECT_EQ((std::vector<int64_t>{ 4, 0, 2, 1, 3 }), survivorsOf(Selection::RANDOM_SEARCH, candidates, 9));
}

TEST(RandomSearch, makesAsManyRobotsAsEvolutionAndAllAtRandom)
{
  const EvolutionSettings settings = baseline(Selection::RANDOM_SEARCH);
  Trial trial(settings, paperBody(), 1);
  GenerationRecord record = evaluateAndSelect(trial);
  double best = record.best_fitness;
  for (int generation = 1; generation <= 5; ++generation)
  {
    trial.breed();
    EXPECT_EQ(7u, trial.awaiting().size());  // 6 in the place of children, 1 injected
    record = evaluateAndSelect(trial);
    EXPECT_GE(record.best_fitness, best);
    best = record.best_fitness;
    for (const Individual& newcomer : record.newcomers)
    {
      EXPECT_EQ(Individual::NO_PARENT, newcomer.parent);
      EXPECT_EQ(bornGenome(settings, layoutOf(settings), 1, generation, newcomer.id, nullptr), newcomer.genome);
    }
  }
}

TEST(NeutralDrift, letsEverybodySurviveEquallyOften)
{
  // Six candidates for two places: each survives a draw with probability 1/3, the fittest and the invalid one alike.
  std::vector<Candidate> candidates;
  for (int64_t id = 0; id < 5; ++id)
  {
    candidates.push_back(valid(id, id, static_cast<double>(id)));
  }
  candidates.push_back({ 5, 0, false, NAN });
  std::map<int64_t, int> survived;
  constexpr int draws = 3000;
  for (int draw = 0; draw < draws; ++draw)
  {
    const std::vector<int64_t> survivors = survivorsOf(Selection::NEUTRAL, candidates, 2, draw);
    ASSERT_EQ(2u, survivors.size());
    ASSERT_NE(survivors[0], survivors[1]);
    for (const int64_t id : survivors)
    {
      ++survived[id];
    }
  }
  for (int64_t id = 0; id < 6; ++id)
  {
    EXPECT_NEAR(draws / 3.0, survived[id], 110.0) << id;  // more than four standard deviations of 25.8
  }
}

TEST(NeutralDrift, listsTheFittestSurvivorFirst)
{
  const std::vector<Candidate> candidates = { valid(0, 0, 1.0), { 1, 0, false, NAN }, valid(2, 5, 3.0) };
  EXPECT_EQ(2, survivorsOf(Selection::NEUTRAL, candidates, 3).front());
}

TEST(NeutralDrift, isAPureFunctionOfTheSeedThatAnotherFitnessDoesNotChange)
{
  // The same survivors, as a set, whatever they are worth.
  std::vector<Candidate> candidates;
  for (int64_t id = 0; id < 9; ++id)
  {
    candidates.push_back(valid(id, 1, static_cast<double>(id)));
  }
  std::vector<int64_t> some = survivorsOf(Selection::NEUTRAL, candidates, 4);
  for (Candidate& candidate : candidates)
  {
    candidate.fitness = -candidate.fitness;
  }
  std::vector<int64_t> others = survivorsOf(Selection::NEUTRAL, candidates, 4);
  std::sort(some.begin(), some.end());
  std::sort(others.begin(), others.end());
  EXPECT_EQ(some, others);
}

TEST(Baselines, haveArmsOfTheirOwn)
{
  EXPECT_EQ("evo_devo/paper/self_adaptive", baseline(Selection::AFPO).arm());
  EXPECT_EQ("evo_devo/paper/self_adaptive/neutral", baseline(Selection::NEUTRAL).arm());
  EXPECT_EQ("evo_devo/paper/self_adaptive/random_search", baseline(Selection::RANDOM_SEARCH).arm());
}

TEST(Baselines, goOnFromTheirSurvivorsAsIfNothingHadHappened)
{
  for (const Selection selection : { Selection::NEUTRAL, Selection::RANDOM_SEARCH })
  {
    const EvolutionSettings settings = baseline(selection);
    Trial unbroken(settings, paperBody(), 1);
    evaluateAndSelect(unbroken);
    Trial resumed(settings, paperBody(), 1, 0, unbroken.individuals(), unbroken.nextId());
    for (int generation = 0; generation < 4; ++generation)
    {
      unbroken.breed();
      resumed.breed();
      EXPECT_EQ(evaluateAndSelect(unbroken).survivors, evaluateAndSelect(resumed).survivors);
    }
  }
}
