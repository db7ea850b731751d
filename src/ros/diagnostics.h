#pragma once

#include "devo_evo/farm/farm.h"

#include <devo_evo/GenerationSummary.h>
#include <diagnostic_msgs/DiagnosticArray.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace devo_evo
{
/// How an experiment is doing, for people.
struct ExperimentStatus
{
  std::string output;
  int64_t trials = 0;
  int64_t trials_finished = 0;
  int64_t generations = 0;
  int64_t generations_committed = 0;  ///< in all trials, generation 0 included, also by earlier runs
  int64_t total_evaluations = 0;
  double evaluations_per_s = 0.0;
  double remaining_s = 0.0;  ///< NaN while unknown
  bool paused = false;
};

/// How a study is doing, for people.
struct StudyStatus
{
  std::string output;
  std::string scale;
  std::string part;    ///< that runs; empty before the first
  int64_t number = 0;  ///< of the part, from 1
  int64_t parts = 0;
  std::string progress;  ///< within the part; empty while nothing is known
};

/// How many of the workers take work.
int64_t usableWorkers(const std::vector<WorkerStatus>& workers);

/// Fills in how many simulators there are in which state.
void countSimulators(const std::vector<WorkerStatus>& workers, GenerationSummary& summary);

/// One status on the experiment (a warning while it is paused or has no simulator), then one on each simulator (a
/// warning if it is late or lost, an error if it was refused or quarantined).
/// @param node name of the node that publishes it.
diagnostic_msgs::DiagnosticArray diagnosticsOf(const std::string& node, const ExperimentStatus& experiment,
                                               const std::vector<WorkerStatus>& workers);

/// The same of a study. @param workers none of a study that needs no simulator just now.
diagnostic_msgs::DiagnosticArray diagnosticsOf(const std::string& node, const StudyStatus& study,
                                               const std::optional<std::vector<WorkerStatus>>& workers);
}  // namespace devo_evo
