#include "devo_evo/experiment/experiment.h"

#include "devo_evo/farm/local_farm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <thread>

namespace devo_evo
{
namespace
{
/// A made-up outcome that depends on the program alone.
Evaluation pretendToSimulate(const DevelopmentalProgram& program)
{
  Evaluation evaluation;
  const Hash128 hash = phenotypeHash(program);
  evaluation.valid = hash[0] > 20;  // some diverge
  if (!evaluation.valid)
  {
    evaluation.divergence = Divergence{ 1 + hash[1], 3, 101.5 };
    return evaluation;
  }
  evaluation.fitness = program.morphology_initial.front() + program.control_initial.back();
  evaluation.displacement_y_voxels = evaluation.fitness * 2.0;
  evaluation.displacement_xy_voxels = std::abs(evaluation.displacement_y_voxels);
  evaluation.turns = 0.0;
  evaluation.airborne_fraction = 0.25;
  evaluation.state_hash = hash[2] + 1u;
  return evaluation;
}

/// A farm without workers: hands back results in random order, some later than others.
class FakeFarm : public Farm
{
public:
  explicit FakeFarm(unsigned seed = 1) : random_(seed) {}

  void submit(std::vector<EvaluationRequest> requests) override
  {
    for (auto& request : requests)
    {
      ++times_requested[phenotypeHash(request.program)];
      requests_.push_back(std::move(request));
    }
  }

  std::vector<EvaluationResult> collect(std::chrono::milliseconds /*timeout*/) override
  {
    if (failure)
    {
      throw std::runtime_error("the farm burned down");
    }
    std::shuffle(requests_.begin(), requests_.end(), random_);
    std::vector<EvaluationResult> results;
    for (size_t left = random_() % 7; left > 0 && !requests_.empty(); --left)
    {
      results.push_back(answer(requests_.back()));
      late_.push_back(results.back());
      requests_.pop_back();
    }
    if (duplicates && !late_.empty() && random_() % 2 == 0)
    {
      results.push_back(late_[random_() % late_.size()]);
    }
    return results;
  }

  std::vector<WorkerStatus> status() const override { return {}; }

  bool outstanding() const { return !requests_.empty(); }

  bool duplicates = false;
  bool failure = false;
  std::map<Hash128, int> times_requested;

private:
  static EvaluationResult answer(const EvaluationRequest& request)
  {
    return { request.trial, request.id, pretendToSimulate(request.program), "nobody" };
  }

  std::mt19937 random_;
  std::vector<EvaluationRequest> requests_;
  std::vector<EvaluationResult> late_;
};

/// Notes what it is told, and does what a test wants then.
class Watcher : public ExperimentObserver
{
public:
  void generationCommitted(const GenerationReport& report) override
  {
    committed.emplace_back(report.record.trial, report.record.generation);
    evaluations += report.evaluations;
    newcomers += static_cast<int64_t>(report.record.newcomers.size());
    EXPECT_EQ(report.champion.id, report.record.champion);
    EXPECT_TRUE(report.champion.evaluation.has_value());
    EXPECT_FALSE(report.champion.genome.program.morphology_initial.empty());
    total_evaluations = report.total_evaluations;
    remaining_s = report.remaining_s;
    if (on_commit)
    {
      on_commit(report);
    }
  }

  void tick() override
  {
    ++ticks;
    if (on_tick)
    {
      on_tick();
    }
  }

  std::vector<std::pair<int64_t, int64_t>> committed;  ///< trial, generation
  int64_t evaluations = 0;
  int64_t newcomers = 0;
  int64_t total_evaluations = 0;  ///< as of the last report
  int64_t ticks = 0;
  double remaining_s = std::nan("");
  std::function<void(const GenerationReport&)> on_commit;
  std::function<void()> on_tick;
};

class ExperimentTest : public ::testing::Test
{
protected:
  ExperimentTest()
  {
    std::string pattern = ::testing::TempDir() + "devo_evo_XXXXXX";
    folder_ = mkdtemp(pattern.data());
    settings_.body.soft.grid_x = settings_.body.soft.grid_y = 2;
    settings_.body.soft.grid_z = 1;
    settings_.body.soft.lifetime = 0.01;
    settings_.evolution.population = 6;
    settings_.trials = 3;
    settings_.generations = 5;
    setOutput("experiment");
  }

  ~ExperimentTest() override { std::filesystem::remove_all(folder_); }

  void setOutput(const std::string& name) { settings_.output = folder_ + "/" + name; }

  std::unique_ptr<Archive> open() const { return openArchiveForWriting(settings_, Provenance()); }

  RunOutcome run(Farm& farm)
  {
    const auto archive = open();
    return Experiment(settings_, *archive, farm, watcher_).run();
  }

  std::string digest() const { return openArchiveForReading(settings_.output)->digest(); }

  /// The digest of the same settings evolved without any disturbance.
  std::string undisturbedDigest()
  {
    const std::string output = settings_.output;
    setOutput("undisturbed");
    FakeFarm farm;
    Watcher watcher;
    const auto archive = open();
    Experiment(settings_, *archive, farm, watcher).run();
    const std::string result = archive->digest();
    settings_.output = output;
    return result;
  }

  std::string folder_;
  ExperimentSettings settings_;
  Watcher watcher_;
};

TEST_F(ExperimentTest, BringsEveryTrialToItsLastGeneration)
{
  FakeFarm farm;
  EXPECT_EQ(run(farm), RunOutcome::FINISHED);
  const std::set<std::pair<int64_t, int64_t>> committed(watcher_.committed.begin(), watcher_.committed.end());
  EXPECT_EQ(committed.size(), 18u);  // 3 trials of generations 0 to 5
  EXPECT_EQ(watcher_.committed.size(), 18u);
  EXPECT_EQ(*committed.begin(), std::make_pair(int64_t{ 1 }, int64_t{ 0 }));
  EXPECT_EQ(*committed.rbegin(), std::make_pair(int64_t{ 3 }, int64_t{ 5 }));
  EXPECT_GT(watcher_.ticks, 0);
  EXPECT_EQ(watcher_.remaining_s, 0.0);
  EXPECT_EQ(watcher_.total_evaluations, watcher_.evaluations);
  for (const auto& state : open()->trialStates())
  {
    EXPECT_EQ(state.second.generation, 5);
    EXPECT_EQ(state.second.survivors.size(), 6u);
    EXPECT_EQ(state.second.next_id, 6 + 5 * 7);  // founders, then children and one injection a generation
  }
}

TEST_F(ExperimentTest, MayEndWithTheFounders)
{
  settings_.generations = 0;
  FakeFarm farm;
  EXPECT_EQ(run(farm), RunOutcome::FINISHED);
  EXPECT_EQ(watcher_.committed.size(), 3u);
}

TEST_F(ExperimentTest, ResultsDoNotDependOnTheOrderOfAnswersNorOnDuplicates)
{
  const std::string expected = undisturbedDigest();
  for (const unsigned seed : { 2u, 3u, 4u })
  {
    setOutput("seed-" + std::to_string(seed));
    FakeFarm farm(seed);
    farm.duplicates = true;
    EXPECT_EQ(run(farm), RunOutcome::FINISHED);
    EXPECT_EQ(digest(), expected) << seed;
  }
}

TEST_F(ExperimentTest, TrialsAdvanceSideBySide)
{
  FakeFarm farm;
  run(farm);
  const auto first_end = std::find_if(watcher_.committed.begin(), watcher_.committed.end(),
                                      [](const auto& commit) { return commit.second == 5; });
  std::set<int64_t> under_way;
  std::for_each(watcher_.committed.begin(), first_end, [&](const auto& commit) { under_way.insert(commit.first); });
  EXPECT_EQ(under_way, (std::set<int64_t>{ 1, 2, 3 }));
}

TEST_F(ExperimentTest, SimulatesEachPhenotypeOnce)
{
  settings_.evolution.mutation_rate = 0.1;  // of 4 values: most children equal their parents
  FakeFarm farm;
  run(farm);
  EXPECT_TRUE(std::all_of(farm.times_requested.begin(), farm.times_requested.end(),
                          [](const auto& each) { return each.second == 1; }));
  EXPECT_LT(watcher_.evaluations, watcher_.newcomers);
  EXPECT_EQ(watcher_.evaluations, static_cast<int64_t>(farm.times_requested.size()));
}

TEST_F(ExperimentTest, GoesOnWhereNothingNewIsEverBorn)
{
  settings_.evolution.mutation_rate = 0.0;
  settings_.evolution.random_injections = 0;
  settings_.trials = 1;
  FakeFarm farm;
  EXPECT_EQ(run(farm), RunOutcome::FINISHED);
  EXPECT_EQ(watcher_.evaluations, 6);
  EXPECT_EQ(watcher_.committed.size(), 6u);
}

TEST_F(ExperimentTest, ResumesWhatWasStoppedAtOnce)
{
  const std::string expected = undisturbedDigest();
  RunOutcome outcome = RunOutcome::STOPPED;
  int runs = 0;
  for (; outcome == RunOutcome::STOPPED && runs < 100; ++runs)
  {
    const auto archive = open();
    FakeFarm fresh_farm(static_cast<unsigned>(runs));
    Experiment experiment(settings_, *archive, fresh_farm, watcher_);
    int ticks = 0;
    watcher_.on_tick = [&]
    {
      if (++ticks == 8)
      {
        experiment.stopNow();
      }
    };
    outcome = experiment.run();
  }
  EXPECT_GT(runs, 2);
  EXPECT_EQ(outcome, RunOutcome::FINISHED);
  EXPECT_EQ(watcher_.committed.size(), 18u);
  EXPECT_EQ(digest(), expected);
}

TEST_F(ExperimentTest, ResumesOnAFarmThatStillAnswersTheFirstRun)
{
  const std::string expected = undisturbedDigest();
  FakeFarm farm;
  const auto archive = open();
  {
    Experiment experiment(settings_, *archive, farm, watcher_);
    watcher_.on_tick = [&] { experiment.stopNow(); };
    EXPECT_EQ(experiment.run(), RunOutcome::STOPPED);
  }
  EXPECT_TRUE(farm.outstanding());
  watcher_.on_tick = nullptr;
  EXPECT_EQ(Experiment(settings_, *archive, farm, watcher_).run(), RunOutcome::FINISHED);
  EXPECT_EQ(archive->digest(), expected);
}

TEST_F(ExperimentTest, FinishesRunningGenerationsWhenToldToStopAfterThem)
{
  const std::string expected = undisturbedDigest();
  FakeFarm farm;
  {
    const auto archive = open();
    Experiment experiment(settings_, *archive, farm, watcher_);
    watcher_.on_commit = [&](const GenerationReport& report)
    {
      if (report.record.generation == 2)
      {
        experiment.stopAfterGeneration();
      }
    };
    EXPECT_EQ(experiment.run(), RunOutcome::STOPPED);
    EXPECT_FALSE(farm.outstanding());
  }
  EXPECT_LT(watcher_.committed.size(), 18u);
  watcher_.on_commit = nullptr;
  EXPECT_EQ(run(farm), RunOutcome::FINISHED);
  EXPECT_EQ(digest(), expected);
}

TEST_F(ExperimentTest, RestsWhilePaused)
{
  const std::string expected = undisturbedDigest();
  FakeFarm farm;
  const auto archive = open();
  Experiment experiment(settings_, *archive, farm, watcher_);
  watcher_.on_commit = [&](const GenerationReport& report)
  {
    if (report.record.generation == 1)
    {
      experiment.pause();
    }
  };
  size_t committed_at_rest = 0;
  int ticks_at_rest = 0;
  watcher_.on_tick = [&]
  {
    if (!experiment.paused() || farm.outstanding())
    {
      return;
    }
    if (++ticks_at_rest == 2)
    {
      committed_at_rest = watcher_.committed.size();
    }
    if (ticks_at_rest == 50)
    {
      EXPECT_EQ(watcher_.committed.size(), committed_at_rest);
      watcher_.on_commit = nullptr;
      experiment.resume();
    }
  };
  EXPECT_EQ(experiment.run(), RunOutcome::FINISHED);
  EXPECT_GE(ticks_at_rest, 50);
  EXPECT_LT(committed_at_rest, 18u);
  EXPECT_EQ(archive->digest(), expected);
}

TEST_F(ExperimentTest, CanBeStoppedWhilePaused)
{
  FakeFarm farm;
  const auto archive = open();
  Experiment experiment(settings_, *archive, farm, watcher_);
  experiment.pause();
  watcher_.on_tick = [&] { experiment.stopAfterGeneration(); };
  EXPECT_EQ(experiment.run(), RunOutcome::STOPPED);
  EXPECT_TRUE(watcher_.committed.empty());
}

TEST_F(ExperimentTest, CanBeStoppedFromAnotherThread)
{
  settings_.generations = 1000000;
  FakeFarm farm;
  const auto archive = open();
  Experiment experiment(settings_, *archive, farm, watcher_);
  std::thread stopper([&experiment] { experiment.stopNow(); });
  EXPECT_EQ(experiment.run(), RunOutcome::STOPPED);
  stopper.join();
}

TEST_F(ExperimentTest, AFinishedOneIsNotRunAgainButMayGrow)
{
  FakeFarm farm;
  run(farm);
  watcher_.committed.clear();
  EXPECT_EQ(run(farm), RunOutcome::FINISHED);
  EXPECT_TRUE(watcher_.committed.empty());

  settings_.generations = 7;
  settings_.trials = 4;
  const std::string expected = undisturbedDigest();
  EXPECT_EQ(run(farm), RunOutcome::FINISHED);
  EXPECT_EQ(watcher_.committed.size(), 3u * 2 + 8);
  EXPECT_EQ(digest(), expected);
}

TEST_F(ExperimentTest, AFailureOfTheFarmLosesNothingThatIsCommitted)
{
  const std::string expected = undisturbedDigest();
  FakeFarm farm;
  watcher_.on_commit = [&](const GenerationReport& report) { farm.failure = report.record.generation == 2; };
  EXPECT_THROW(run(farm), std::runtime_error);
  watcher_.on_commit = nullptr;
  FakeFarm other_farm;
  EXPECT_EQ(run(other_farm), RunOutcome::FINISHED);
  EXPECT_EQ(watcher_.committed.size(), 18u);
  EXPECT_EQ(digest(), expected);
}

TEST_F(ExperimentTest, EvolvesTheSameOnAnyNumberOfThreads)
{
  std::set<std::string> digests;
  for (const int threads : { 1, 2, 5 })
  {
    setOutput("threads-" + std::to_string(threads));
    const auto farm = makeLocalFarm(makeBody(settings_.body), threads);
    EXPECT_EQ(run(*farm), RunOutcome::FINISHED);
    digests.insert(digest());
  }
  EXPECT_EQ(digests.size(), 1u);
}

TEST_F(ExperimentTest, RefusesSettingsThatCannotBe)
{
  const auto archive = open();
  FakeFarm farm;
  settings_.trials = 0;
  EXPECT_THROW(Experiment(settings_, *archive, farm, watcher_), InvalidInput);
}
}  // namespace
}  // namespace devo_evo
