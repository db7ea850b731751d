// Runs an experiment of many trials on a farm that answers at once with made-up results, and tells how the archive and
// this process's memory grow: what remains of an experiment when nothing is simulated.

#include "benchmark/temporary_folder.h"
#include "devo_evo/evolution/genome.h"
#include "devo_evo/experiment/experiment.h"
#include "devo_evo/soft_body/text.h"

#include <nlohmann/json.hpp>

#include <charconv>
#include <chrono>
#include <cmath>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace devo_evo
{
namespace
{
using Clock = std::chrono::steady_clock;

/// Answers at once. Fitness is a smooth function of the genes, so that evolution climbs and lineages are as in earnest.
class MadeUpFarm : public Farm
{
public:
  void submit(std::vector<EvaluationRequest> requests) override
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const EvaluationRequest& request : requests)
    {
      results_.push_back({ request.trial, request.id, makeUp(request.program), "nobody" });
    }
  }

  std::vector<EvaluationResult> collect(std::chrono::milliseconds) override
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(results_, {});
  }

  std::vector<WorkerStatus> status() const override { return {}; }

private:
  static Evaluation makeUp(const DevelopmentalProgram& program)
  {
    Evaluation evaluation;
    evaluation.valid = true;
    evaluation.fitness = 0.0;
    double weight = 1.0;
    for (size_t i = 0; i < program.morphology_initial.size(); ++i)
    {
      weight = -0.97 * weight;
      evaluation.fitness += weight * (program.morphology_initial[i] + 0.5 * program.morphology_final[i] +
                                      program.control_initial[i] * program.control_final[i]);
    }
    evaluation.displacement_y_voxels = 4.0 * evaluation.fitness;
    evaluation.displacement_xy_voxels = std::abs(evaluation.displacement_y_voxels);
    evaluation.turns = 0.1 * evaluation.fitness;
    evaluation.airborne_fraction = 0.1;
    const Hash128 hash = phenotypeHash(program);
    std::memcpy(&evaluation.state_hash, hash.data(), sizeof evaluation.state_hash);
    return evaluation;
  }

  std::mutex mutex_;
  std::vector<EvaluationResult> results_;
};

/// A line of /proc/self/status, in bytes; 0 where there is none.
int64_t memoryOf(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word)
  {
    int64_t kilobytes = 0;
    if (word == name + ":" && status >> kilobytes)
    {
      return kilobytes * 1024;
    }
  }
  return 0;
}

/// Bytes of all files in a folder.
int64_t sizeOf(const std::string& folder)
{
  int64_t size = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    size += static_cast<int64_t>(entry.file_size());
  }
  return size;
}

/// Stops the experiment in time, and takes samples of its growth on the way.
class GrowthObserver : public ExperimentObserver
{
public:
  GrowthObserver(std::string output, std::chrono::seconds duration)
    : output_(std::move(output)), duration_(duration), start_(Clock::now())
  {
  }

  void watch(Experiment& experiment) { experiment_ = &experiment; }

  void generationCommitted(const GenerationReport&) override
  {
    ++commits_;
    const Clock::duration run = Clock::now() - start_;
    if (run > duration_ * static_cast<int>(samples_.size() + 1) / SAMPLES)
    {
      samples_.push_back(sample());
    }
    if (run > duration_)
    {
      experiment_->stopAfterGeneration();
    }
  }

  nlohmann::json sample() const
  {
    return { { "seconds", std::chrono::duration<double>(Clock::now() - start_).count() },
             { "commits", commits_ },
             { "output_bytes", sizeOf(output_) },
             { "resident_bytes", memoryOf("VmRSS") },
             { "peak_resident_bytes", memoryOf("VmHWM") } };
  }

  const nlohmann::json& samples() const { return samples_; }

private:
  static constexpr int SAMPLES = 10;

  const std::string output_;
  const std::chrono::seconds duration_;
  const Clock::time_point start_;
  Experiment* experiment_ = nullptr;
  int64_t commits_ = 0;
  nlohmann::json samples_ = nlohmann::json::array();
};

nlohmann::json measureGrowth(int trials, int seconds)
{
  constexpr int64_t no_end = 1000000;
  const TemporaryFolder folder;
  ExperimentSettings settings;
  settings.trials = trials;
  settings.generations = no_end;
  settings.output = folder.path();
  GrowthObserver observer(settings.output, std::chrono::seconds(seconds));
  {
    const auto archive = openArchiveForWriting(settings, Provenance{});
    MadeUpFarm farm;
    Experiment experiment(settings, *archive, farm, observer);
    observer.watch(experiment);
    experiment.run();
  }
  return { { "trials", trials }, { "samples", observer.samples() }, { "closed", observer.sample() } };
}

int parseCount(const char* text)
{
  int number = 0;
  const char* end = text + std::strlen(text);
  const auto result = std::from_chars(text, end, number);
  if (result.ec != std::errc() || result.ptr != end || number < 1)
  {
    throw InvalidInput(std::string("\"") + text + "\" is no number of trials or seconds");
  }
  return number;
}
}  // namespace
}  // namespace devo_evo

/// Usage: devo_evo_archive_benchmark [TRIALS [SECONDS]]; prints JSON.
int main(int argc, char** argv)
{
  try
  {
    const int trials = argc > 1 ? devo_evo::parseCount(argv[1]) : 30;
    const int seconds = argc > 2 ? devo_evo::parseCount(argv[2]) : 60;
    std::cout << devo_evo::measureGrowth(trials, seconds).dump(2) << std::endl;
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "devo_evo_archive_benchmark: " << error.what() << std::endl;
    return 1;
  }
}
