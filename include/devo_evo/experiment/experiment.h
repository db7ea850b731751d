#pragma once

#include "devo_evo/archive/archive.h"
#include "devo_evo/experiment/settings.h"
#include "devo_evo/farm/farm.h"

#include <atomic>
#include <cstdint>

namespace devo_evo
{
/// What an observer learns of each committed generation.
struct GenerationReport
{
  const GenerationRecord& record;
  const Individual& champion;      ///< with genome and evaluation
  int64_t evaluations = 0;         ///< simulated for this generation; the others were known already
  int64_t total_evaluations = 0;   ///< simulated since this run began, all trials
  double evaluations_per_s = 0.0;  ///< over the last seconds; NaN while unknown
  double remaining_s = 0.0;        ///< estimated time to the end of the experiment; NaN while unknown
};

/// Somebody who watches an experiment. Called from the thread that runs it.
class ExperimentObserver
{
public:
  virtual ~ExperimentObserver() = default;
  virtual void generationCommitted(const GenerationReport& report) = 0;

  /// Called several times a second, also while nothing happens.
  virtual void tick() {}
};

/// How a run ended.
enum class RunOutcome
{
  FINISHED,  ///< every trial has reached the last generation
  STOPPED    ///< it was stopped, and can be resumed
};

/// Runs an experiment: all trials side by side on one farm into one archive. Robots with the same phenotype are
/// simulated once. What ends up in the archive does not depend on the farm, nor on pauses and stops.
class Experiment
{
public:
  /// Resumes where the archive ends. All references must outlive the experiment. @throw InvalidInput
  Experiment(const ExperimentSettings& settings, Archive& archive, Farm& farm, ExperimentObserver& observer);

  /// Runs until all trials are finished or it is stopped. @throw ArchiveError if a generation cannot be committed, and
  /// whatever farm and observer throw; the archive can be resumed then, too.
  RunOutcome run();

  /// Lets running generations finish but starts no new one, until resume(). From any thread.
  void pause() { paused_ = true; }
  void resume() { paused_ = false; }
  bool paused() const { return paused_; }

  /// Lets running generations finish, then ends run(). From any thread.
  void stopAfterGeneration() { stop_after_generation_ = true; }

  /// Ends run() at once; generations not committed are evolved again, equally, when the experiment is resumed.
  /// Async-signal-safe.
  void stopNow() { stop_now_ = true; }

private:
  class Run;

  const ExperimentSettings settings_;
  Archive& archive_;
  Farm& farm_;
  ExperimentObserver& observer_;
  std::atomic<bool> paused_{ false };
  std::atomic<bool> stop_after_generation_{ false };
  std::atomic<bool> stop_now_{ false };
  static_assert(std::atomic<bool>::is_always_lock_free, "stopNow() is called by signal handlers");
};
}  // namespace devo_evo
