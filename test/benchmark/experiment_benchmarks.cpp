#include "benchmark/experiment_benchmarks.h"

#include "benchmark/known_results.h"
#include "benchmark/temporary_folder.h"
#include "devo_evo/experiment/build_info.h"
#include "devo_evo/experiment/experiment.h"
#include "devo_evo/farm/local_farm.h"
#include "devo_evo/soft_body/text.h"

#include <benchmark/benchmark.h>

#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace devo_evo
{
namespace
{
struct ExperimentScene
{
  std::string name;
  int trials;
  int generations;  ///< after the founders
};

const std::vector<ExperimentScene> SCENES = { { "one_trial", 1, 3 }, { "four_trials", 4, 2 } };

/// Remembers what became of everybody.
class ResultObserver : public ExperimentObserver
{
public:
  void generationCommitted(const GenerationReport& report) override
  {
    evaluations_ = report.total_evaluations;
    for (const Individual& newcomer : report.record.newcomers)
    {
      results_[newcomer.trial].push_back(*newcomer.evaluation);
    }
  }

  int64_t evaluations() const { return evaluations_; }

  /// Of all trials in their order, whichever was the faster.
  uint64_t hash() const
  {
    std::vector<Evaluation> all;
    for (const auto& [trial, results] : results_)
    {
      all.insert(all.end(), results.begin(), results.end());
    }
    return combinedHash(all);
  }

private:
  int64_t evaluations_ = 0;
  std::map<int64_t, std::vector<Evaluation>> results_;
};

/// An experiment that is ready to be run once.
class PreparedExperiment
{
public:
  PreparedExperiment(const ExperimentScene& scene, int threads)
    : settings_(settingsOf(scene, folder_.path()))
    , archive_(openArchiveForWriting(settings_, Provenance{}))
    , farm_(makeLocalFarm(makeBody(settings_.body), threads))
    , experiment_(settings_, *archive_, *farm_, observer_)
  {
  }

  void run() { experiment_.run(); }
  const ResultObserver& results() const { return observer_; }

private:
  static ExperimentSettings settingsOf(const ExperimentScene& scene, const std::string& output)
  {
    ExperimentSettings settings;
    settings.trials = scene.trials;
    settings.generations = scene.generations;
    settings.output = output;
    return settings;
  }

  TemporaryFolder folder_;
  const ExperimentSettings settings_;
  ResultObserver observer_;
  std::unique_ptr<Archive> archive_;
  std::unique_ptr<Farm> farm_;
  Experiment experiment_;
};

void runExperiment(benchmark::State& state, const ExperimentScene& scene, int threads)
{
  using benchmark::Counter;
  PreparedExperiment experiment(scene, threads);
  for (auto _ : state)
  {
    experiment.run();
  }
  verifyResults(scene.name, experiment.results().hash());
  const auto evaluations = static_cast<double>(experiment.results().evaluations());
  const double generations = scene.trials * (scene.generations + 1);
  state.counters["trials"] = scene.trials;
  state.counters["evaluations"] = evaluations;
  state.counters["evaluations_per_s_and_core"] = Counter(evaluations / threads, Counter::kIsRate);
  state.counters["generations_per_s"] = Counter(generations, Counter::kIsRate);
}
}  // namespace

void registerExperimentBenchmarks()
{
  for (const ExperimentScene& scene : SCENES)
  {
    for (const int threads : { 1, 2 })
    {
      const std::string name = "experiments/" + scene.name + "/threads:" + toText(threads);
      benchmark::RegisterBenchmark(name.c_str(), runExperiment, scene, threads)
          ->Iterations(1)
          ->UseRealTime()
          ->MeasureProcessCPUTime()
          ->Unit(benchmark::kMillisecond);
    }
  }
}

void printExperimentHashes()
{
  for (const ExperimentScene& scene : SCENES)
  {
    PreparedExperiment experiment(scene, 2);
    experiment.run();
    std::cout << scene.name << " " << hashToString(experiment.results().hash()) << std::endl;
  }
}
}  // namespace devo_evo
