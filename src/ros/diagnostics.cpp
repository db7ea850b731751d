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

DiagnosticStatus statusOf(const StudyStatus& study, const std::optional<std::vector<WorkerStatus>>& workers)
{
  const int64_t usable = workers ? usableWorkers(*workers) : 0;
  const bool waits = workers && usable == 0;
  DiagnosticStatus status;
  status.level = waits ? DiagnosticStatus::WARN : DiagnosticStatus::OK;
  status.message = waits ? "waiting for a simulator" : study.part.empty() ? "beginning" : "running " + study.part;
  add(status, "output", study.output);
  add(status, "scale", study.scale);
  add(status, "part", study.part);
  add(status, "number of the part", toText(study.number) + " of " + toText(study.parts));
  add(status, "progress", study.progress);
  add(status, "usable simulators", toText(usable));
  return status;
}

uint8_t levelOf(WorkerState state)
{
  switch (state)
  {
    case WorkerState::LATE:
    case WorkerState::LOST:
      return DiagnosticStatus::WARN;
    case WorkerState::REFUSED:
    case WorkerState::QUARANTINED:
      return DiagnosticStatus::ERROR;
    default:
      return DiagnosticStatus::OK;
  }
}

DiagnosticStatus statusOf(const WorkerStatus& worker)
{
  DiagnosticStatus status;
  status.level = levelOf(worker.state);
  status.message = stateText(worker);
  status.hardware_id = worker.host;
  add(status, "host", worker.host);
  add(status, "evaluations", toText(worker.evaluations));
  add(status, "evaluations checked", toText(worker.checked));
  add(status, "times lost", toText(worker.losses));
  if (worker.losses > 0)
  {
    add(status, "last trouble", worker.reason);
  }
  return status;
}

diagnostic_msgs::DiagnosticArray diagnosticsOf(const std::string& node, const std::string& subject,
                                               DiagnosticStatus status, const std::vector<WorkerStatus>& workers)
{
  diagnostic_msgs::DiagnosticArray diagnostics;
  diagnostics.header.stamp = wallStamp();
  diagnostics.status.push_back(std::move(status));
  diagnostics.status.back().name = node + ": " + subject;
  for (const WorkerStatus& worker : workers)
  {
    diagnostics.status.push_back(statusOf(worker));
    diagnostics.status.back().name = node + ": simulator " + worker.name;
  }
  return diagnostics;
}
}  // namespace

int64_t usableWorkers(const std::vector<WorkerStatus>& workers)
{
  return std::count_if(workers.begin(), workers.end(), [](const WorkerStatus& worker) { return worker.usable(); });
}

void countSimulators(const std::vector<WorkerStatus>& workers, GenerationSummary& summary)
{
  const auto count = [&](const auto& condition)
  { return static_cast<int32_t>(std::count_if(workers.begin(), workers.end(), condition)); };
  summary.simulators = count([](const WorkerStatus& worker) { return worker.usable(); });
  summary.simulators_late = count([](const WorkerStatus& worker) { return worker.state == WorkerState::LATE; });
  summary.simulators_lost = count([](const WorkerStatus& worker) { return worker.state == WorkerState::LOST; });
  summary.simulators_rejected =
      count([](const WorkerStatus& worker) { return levelOf(worker.state) == DiagnosticStatus::ERROR; });
}

diagnostic_msgs::DiagnosticArray diagnosticsOf(const std::string& node, const ExperimentStatus& experiment,
                                               const std::vector<WorkerStatus>& workers)
{
  return diagnosticsOf(node, "experiment", statusOf(experiment, usableWorkers(workers)), workers);
}

diagnostic_msgs::DiagnosticArray diagnosticsOf(const std::string& node, const StudyStatus& study,
                                               const std::optional<std::vector<WorkerStatus>>& workers)
{
  return diagnosticsOf(node, "study", statusOf(study, workers), workers.value_or(std::vector<WorkerStatus>()));
}
}  // namespace devo_evo
