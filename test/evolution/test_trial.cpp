#include "devo_evo/evolution/trial.h"

#include "evolution/golden.h"
#include "evolution/settings_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace devo_evo;

namespace
{
/// A made-up fitness of a few additions and multiplications, the same everywhere; one in sixteen robots is invalid.
Evaluation madeUpEvaluation(const Genome& genome)
{
  Evaluation evaluation;
  const Hash128 hash = phenotypeHash(genome.program);
  evaluation.valid = hash[0] >= 16;
  if (!evaluation.valid)
  {
    evaluation.divergence = Divergence{ 1, 0, 101.0 };
    return evaluation;
  }
  double fitness = 0.0;
  for (size_t voxel = 0; voxel < genome.program.control_initial.size(); ++voxel)
  {
    const double weight = static_cast<double>(voxel % 5) - 1.5;
    fitness += weight * (genome.program.morphology_initial[voxel] + 0.5 * genome.program.morphology_final[voxel]);
    fitness += genome.program.control_initial[voxel] * genome.program.control_final[voxel];
  }
  evaluation.fitness = fitness;
  evaluation.state_hash = hash[1];
  return evaluation;
}

void evaluateAll(Trial& trial)
{
  for (const int64_t id : trial.awaiting())
  {
    trial.setEvaluation(id, madeUpEvaluation(trial.individual(id).genome));
  }
}

std::vector<GenerationRecord> evolve(Trial& trial, int generations)
{
  std::vector<GenerationRecord> records;
  for (int i = 0; i < generations; ++i)
  {
    trial.breed();
    evaluateAll(trial);
    records.push_back(trial.select());
  }
  return records;
}

/// Everything that evolution decided.
std::string digestOf(const std::vector<GenerationRecord>& records)
{
  Sha256 hash;
  for (const GenerationRecord& record : records)
  {
    hash.add(record.trial).add(record.generation).add(record.champion);
    hash.add(record.best_fitness).add(record.median_fitness);
    for (const Individual& newcomer : record.newcomers)
    {
      hash.add(newcomer.id).add(newcomer.parent).add(newcomer.age);
      hash.add(toHex(genomeHash(newcomer.genome)));
    }
    for (const int64_t survivor : record.survivors)
    {
      hash.add(survivor);
    }
  }
  return digestOf(hash);
}

std::string digestOfTrial(const EvolutionSettings& settings, int64_t number = 0)
{
  Trial trial(settings, paperBody(), number);
  evaluateAll(trial);
  std::vector<GenerationRecord> records = { trial.select() };
  for (GenerationRecord& record : evolve(trial, 10))
  {
    records.push_back(std::move(record));
  }
  return digestOf(records);
}

Evaluation withFitness(double fitness)
{
  Evaluation evaluation;
  evaluation.valid = true;
  evaluation.fitness = fitness;
  return evaluation;
}

EvolutionSettings smallSettings()
{
  EvolutionSettings settings;
  settings.population = 4;
  return settings;
}
}  // namespace

TEST(Trial, beginsWithRandomFoundersAwaitingEvaluation)
{
  const Trial trial(smallSettings(), paperBody(), 7);
  EXPECT_EQ(7, trial.number());
  EXPECT_EQ(0, trial.generation());
  EXPECT_EQ(4, trial.nextId());
  EXPECT_EQ((std::vector<int64_t>{ 0, 1, 2, 3 }), trial.awaiting());
  for (const Individual& founder : trial.individuals())
  {
    EXPECT_EQ(7, founder.trial);
    EXPECT_EQ(Individual::NO_PARENT, founder.parent);
    EXPECT_EQ(0, founder.generation);
    EXPECT_EQ(0, founder.age);
    EXPECT_EQ(bornGenome(smallSettings(), layoutOf(smallSettings()), 7, 0, founder.id, nullptr), founder.genome);
  }
}

TEST(Trial, keepsEveryFounderInRankingOrder)
{
  Trial trial(smallSettings(), paperBody(), 0);
  const double fitnesses[4] = { 2.0, 8.0, -1.0, 5.0 };
  for (int64_t id = 0; id < 4; ++id)
  {
    trial.setEvaluation(id, withFitness(fitnesses[id]));
  }
  const GenerationRecord record = trial.select();
  EXPECT_EQ(0, record.generation);
  EXPECT_EQ((std::vector<int64_t>{ 1, 3, 0, 2 }), record.survivors);
  EXPECT_EQ(1, record.champion);
  EXPECT_EQ(8.0, record.best_fitness);
  EXPECT_EQ(3.5, record.median_fitness);  // of 2 and 5
  ASSERT_EQ(4u, record.newcomers.size());
  for (int64_t id = 0; id < 4; ++id)
  {
    EXPECT_EQ(id, record.newcomers[id].id);
    EXPECT_EQ(fitnesses[id], record.newcomers[id].evaluation->fitness);
    EXPECT_EQ(48u, record.newcomers[id].genome.program.control_final.size());
  }
}

TEST(Trial, describesTheValidSurvivorsOnly)
{
  Trial trial(smallSettings(), paperBody(), 0);
  trial.setEvaluation(0, Evaluation());
  trial.setEvaluation(1, withFitness(-3.0));
  trial.setEvaluation(2, withFitness(-1.0));
  trial.setEvaluation(3, withFitness(-7.0));
  const GenerationRecord record = trial.select();
  EXPECT_EQ(2, record.champion);
  EXPECT_EQ(-1.0, record.best_fitness);
  EXPECT_EQ(-3.0, record.median_fitness);
  EXPECT_EQ((std::vector<int64_t>{ 2, 1, 3, 0 }), record.survivors);
}

TEST(Trial, goesOnIfNobodyIsValid)
{
  Trial trial(smallSettings(), paperBody(), 0);
  for (int64_t id = 0; id < 4; ++id)
  {
    trial.setEvaluation(id, Evaluation());
  }
  const GenerationRecord record = trial.select();
  EXPECT_EQ(3, record.champion);  // of equals the newest
  EXPECT_TRUE(std::isnan(record.best_fitness));
  EXPECT_TRUE(std::isnan(record.median_fitness));
  trial.breed();
  EXPECT_EQ(5u, trial.awaiting().size());
}

TEST(Trial, breedsOneChildOfEachSurvivorAndInjectsRandomIndividuals)
{
  EvolutionSettings settings = smallSettings();
  settings.random_injections = 2;
  Trial trial(settings, paperBody(), 0);
  evaluateAll(trial);
  trial.select();
  trial.breed();

  EXPECT_EQ(1, trial.generation());
  ASSERT_EQ(10u, trial.individuals().size());
  EXPECT_EQ((std::vector<int64_t>{ 4, 5, 6, 7, 8, 9 }), trial.awaiting());
  std::set<int64_t> parents;
  for (int64_t id = 4; id < 8; ++id)
  {
    const Individual& child = trial.individual(id);
    const Individual& parent = trial.individual(child.parent);
    parents.insert(child.parent);
    EXPECT_EQ(1, child.generation);
    EXPECT_EQ(1, child.age);
    EXPECT_EQ(1, parent.age);
    EXPECT_EQ(bornGenome(settings, layoutOf(settings), 0, 1, id, &parent.genome), child.genome);
  }
  EXPECT_EQ((std::set<int64_t>{ 0, 1, 2, 3 }), parents);
  for (int64_t id = 8; id < 10; ++id)
  {
    const Individual& random = trial.individual(id);
    EXPECT_EQ(Individual::NO_PARENT, random.parent);
    EXPECT_EQ(0, random.age);
    EXPECT_EQ(bornGenome(settings, layoutOf(settings), 0, 1, id, nullptr), random.genome);
  }
}

TEST(Trial, shufflesTheOrderOfParents)
{
  // Who is the parent of the first child: each survivor equally often.
  constexpr int64_t trials = 2000;
  std::vector<int> frequency(4, 0);
  for (int64_t number = 0; number < trials; ++number)
  {
    Trial trial(smallSettings(), *bodyOf(1, 1, 1), number);
    for (int64_t id = 0; id < 4; ++id)
    {
      trial.setEvaluation(id, withFitness(static_cast<double>(id)));
    }
    trial.select();
    trial.breed();
    ++frequency[trial.individual(4).parent];
  }
  for (const int count : frequency)
  {
    EXPECT_NEAR(trials / 4, count, 4.0 * std::sqrt(trials * 3.0 / 16.0));
  }
}

TEST(Trial, agesSurvivorsAndTheirChildrenTogether)
{
  Trial trial(smallSettings(), paperBody(), 0);
  evaluateAll(trial);
  trial.select();
  for (int64_t generation = 1; generation <= 20; ++generation)
  {
    trial.breed();
    for (const Individual& individual : trial.individuals())
    {
      EXPECT_LE(individual.age, generation);
      if (individual.parent != Individual::NO_PARENT && individual.generation == generation)
      {
        EXPECT_EQ(trial.individual(individual.parent).age, individual.age);
      }
    }
    evaluateAll(trial);
    EXPECT_EQ(4u, trial.select().survivors.size());
  }
}

TEST(Trial, neverLosesTheFittest)
{
  Trial trial(settingsOf(Treatment::EVO_DEVO, Profile::PAPER), paperBody(), 0);
  evaluateAll(trial);
  double best = trial.select().best_fitness;
  for (const GenerationRecord& record : evolve(trial, 50))
  {
    EXPECT_GE(record.best_fitness, best);
    EXPECT_EQ(record.champion, record.survivors[0]);
    best = record.best_fitness;
  }
}

TEST(Trial, doesNotDependOnTheOrderOfEvaluations)
{
  Trial forwards(smallSettings(), paperBody(), 0);
  Trial backwards(smallSettings(), paperBody(), 0);
  for (int generation = 0; generation < 10; ++generation)
  {
    evaluateAll(forwards);
    std::vector<int64_t> ids = backwards.awaiting();
    std::reverse(ids.begin(), ids.end());
    for (const int64_t id : ids)
    {
      backwards.setEvaluation(id, madeUpEvaluation(backwards.individual(id).genome));
    }
    EXPECT_EQ(digestOf({ forwards.select() }), digestOf({ backwards.select() }));
    forwards.breed();
    backwards.breed();
  }
}

TEST(Trial, goesOnAfterARestartAsIfItHadNeverStopped)
{
  const EvolutionSettings settings = settingsOf(Treatment::EVO_DEVO, Profile::RELEASED_CODE);
  Trial unbroken(settings, paperBody(), 3);
  evaluateAll(unbroken);
  unbroken.select();
  evolve(unbroken, 5);

  Trial restarted(settings, paperBody(), 3, unbroken.generation(), unbroken.individuals(), unbroken.nextId());
  EXPECT_EQ(digestOf(evolve(unbroken, 5)), digestOf(evolve(restarted, 5)));
}

TEST(Trial, ofAFixedSeedHasAFixedLineage)
{
  EXPECT_EQ("298d6b23e765e05c", digestOfTrial(settingsOf(Treatment::EVO_DEVO, Profile::PAPER)));
  EXPECT_EQ("ae964bb606118dde", digestOfTrial(settingsOf(Treatment::EVO, Profile::PAPER)));
  EXPECT_EQ("acbcc9a28a57d724", digestOfTrial(settingsOf(Treatment::EVO_DEVO, Profile::RELEASED_CODE)));
  EXPECT_EQ("933d95ed11a736d6", digestOfTrial(settingsOf(Treatment::EVO, Profile::RELEASED_CODE, 0.5)));
}

TEST(Trial, dependsOnSeedAndNumber)
{
  EvolutionSettings settings;
  std::set<std::string> digests = { digestOfTrial(settings, 0), digestOfTrial(settings, 1) };
  settings.seed = 2;
  digests.insert(digestOfTrial(settings, 0));
  EXPECT_EQ(3u, digests.size());
}

TEST(Trial, ofAnotherArmHasIndependentFounders)
{
  // Without independence, founders of two profiles would be the same up to the phases' scale.
  const std::vector<EvolutionSettings> arms = {
    settingsOf(Treatment::EVO, Profile::PAPER),           settingsOf(Treatment::EVO_DEVO, Profile::PAPER),
    settingsOf(Treatment::EVO, Profile::RELEASED_CODE),   settingsOf(Treatment::EVO_DEVO, Profile::RELEASED_CODE),
    settingsOf(Treatment::EVO, Profile::PAPER, 0.5),      settingsOf(Treatment::EVO, Profile::PAPER, 0.25),
    settingsOf(Treatment::EVO_DEVO, Profile::PAPER, 0.5),
  };
  std::set<double> first_genes;
  for (const EvolutionSettings& settings : arms)
  {
    first_genes.insert(Trial(settings, paperBody(), 0).individual(0).genome.program.morphology_initial[0]);
  }
  EXPECT_EQ(arms.size(), first_genes.size());
}

TEST(Trial, refusesWhatItsStateDoesNotAllow)
{
  Trial trial(smallSettings(), paperBody(), 0);
  EXPECT_THROW(trial.select(), std::logic_error);  // nobody has been evaluated
  EXPECT_THROW(trial.breed(), std::logic_error);   // nobody has been selected
  EXPECT_THROW(trial.individual(4), std::out_of_range);
  EXPECT_THROW(trial.setEvaluation(4, withFitness(1.0)), std::out_of_range);
  EXPECT_THROW(trial.setEvaluation(0, withFitness(NAN)), InvalidInput);

  trial.setEvaluation(0, withFitness(1.0));
  EXPECT_NO_THROW(trial.setEvaluation(0, withFitness(1.0)));
  EXPECT_THROW(trial.setEvaluation(0, withFitness(2.0)), std::logic_error);
  EXPECT_THROW(trial.setEvaluation(0, Evaluation()), std::logic_error);

  evaluateAll(trial);
  trial.select();
  EXPECT_THROW(trial.select(), std::logic_error);
}

TEST(Trial, refusesToGoOnFromAnIncompleteState)
{
  Trial trial(smallSettings(), paperBody(), 0);
  EXPECT_THROW(Trial(smallSettings(), paperBody(), 0, 5, {}, 10), std::invalid_argument);
  EXPECT_THROW(Trial(smallSettings(), paperBody(), 0, 0, trial.individuals(), 4), std::invalid_argument);
  evaluateAll(trial);
  EXPECT_THROW(Trial(smallSettings(), paperBody(), 0, 0, trial.individuals(), 3), std::invalid_argument);
  EXPECT_NO_THROW(Trial(smallSettings(), paperBody(), 0, 0, trial.individuals(), 4));
}
