#include "ros/diagnostics.h"

#include "devo_evo/experiment/report_text.h"
#include "devo_evo/soft_body/text.h"
#include "ros/conversions.h"

#include <algorithm>

namespace devo_evo
{
namespace
{
using diagnostic_msgs::DiagnosticStatus;

void add(DiagnosticStatus& status, const std::string& key, const std::string& value)
{
  diagnostic_msgs::KeyValue entry;
  entry.key = key;
  entry.value = value;
  status.values.push_back(entry);
}

DiagnosticStatus statusOf(const ExperimentStatus& experiment, int64_t usable)
{
  DiagnosticStatus status;
  status.level = DiagnosticStatus::OK;
  status.message = "evolving";
  if (experiment.trials_finished == experiment.trials)
  {
    status.message = "finished";
  }
  else if (experiment.paused)
  {
    status.level = DiagnosticStatus::WARN;
    status.message = "paused";
  }
  else if (usable == 0)
  {
    status.level = DiagnosticStatus::WARN;
    status.message = "waiting for a simulator";
  }
  add(status, "output", experiment.output);
  add(status, "trials", toText(experiment.trials));
  add(status, "trials finished", toText(experiment.trials_finished));
  add(status, "generations per trial", toText(experiment.generations));
  add(status, "generations committed", toText(experiment.generations_committed));
  add(status, "evaluations since start", toText(experiment.total_evaluations));
  add(status, "evaluations per second", fixedText(experiment.evaluations_per_s, 1));
  add(status, "time left", durationText(experiment.remaining_s));
  add(status, "usable simulators", toText(usable));
  return status;
}

DiagnosticStatus statusOf(const WorkerStatus& worker)
{
  DiagnosticStatus status;
  const bool refused = worker.state.rfind("refused", 0) == 0;
  const bool lost = worker.state.rfind("lost", 0) == 0;
  status.level = refused ? DiagnosticStatus::ERROR : lost ? DiagnosticStatus::WARN : DiagnosticStatus::OK;
  status.message = worker.state;
  add(status, "evaluations", toText(worker.evaluations));
  return status;
}
}  // namespace

int64_t usableWorkers(const std::vector<WorkerStatus>& workers)
{
  return std::count_if(workers.begin(), workers.end(), [](const WorkerStatus& worker) { return worker.usable; });
}

diagnostic_msgs::DiagnosticArray diagnosticsOf(const std::string& node, const ExperimentStatus& experiment,
                                               const std::vector<WorkerStatus>& workers)
{
  diagnostic_msgs::DiagnosticArray diagnostics;
  diagnostics.header.stamp = wallStamp();
  diagnostics.status.push_back(statusOf(experiment, usableWorkers(workers)));
  diagnostics.status.back().name = node + ": experiment";
  for (const WorkerStatus& worker : workers)
  {
    diagnostics.status.push_back(statusOf(worker));
    diagnostics.status.back().name = node + ": simulator " + worker.name;
  }
  return diagnostics;
}
}  // namespace devo_evo
