#include "devo_evo/experiment/report_text.h"

#include "devo_evo/soft_body/text.h"

#include <cmath>
#include <map>

namespace devo_evo
{
namespace
{
std::string describe(const ArchivedIndividual& robot, const Body& body)
{
  const Individual& individual = robot.individual;
  return "Best robot: " + individualName(individual.trial, individual.id) + ", born in generation " +
         toText(individual.generation) + "\n" +                   //
         "    " + body.describe(*individual.evaluation) + "\n" +  //
         "    developmental windows: W_L " + fixedText(robot.morphology_window, 3) + " (body), W_Phi " +
         fixedText(robot.control_window, 3) + " (control)\n";
}

/// "3 evaluations".
std::string counted(int64_t count, const std::string& noun)
{
  return toText(count) + " " + noun + (count == 1 ? "" : "s");
}

struct HostWork
{
  int64_t usable = 0;
  int64_t evaluations = 0;
};

bool inTrouble(const WorkerStatus& worker)
{
  return worker.state == WorkerState::LATE || worker.state == WorkerState::LOST ||
         worker.state == WorkerState::REFUSED || worker.state == WorkerState::QUARANTINED;
}
}  // namespace

std::string durationText(double seconds)
{
  constexpr double longest = 1e15;
  if (!(std::abs(seconds) < longest))
  {
    return "unknown";
  }
  const auto whole = static_cast<int64_t>(std::llround(seconds));
  const int64_t minutes = whole / 60, hours = minutes / 60, days = hours / 24;
  if (days > 0)
  {
    return toText(days) + " d " + toText(hours % 24) + " h";
  }
  if (hours > 0)
  {
    return toText(hours) + " h " + toText(minutes % 60) + " min";
  }
  return (minutes > 0 ? toText(minutes) + " min " : "") + toText(whole % 60) + " s";
}

std::string progressText(const GenerationReport& report, const ExperimentSettings& settings)
{
  const GenerationRecord& record = report.record;
  const std::shared_ptr<const Body> body = makeBody(settings.body);
  return "trial " + toText(record.trial) + "/" + toText(settings.trials) + ", generation " + toText(record.generation) +
         "/" + toText(settings.generations) + ": best " + body->fitnessText(record.best_fitness) + ", median " +
         body->fitnessText(record.median_fitness) + " " + body->fitnessUnit() + "; " +
         fixedText(report.evaluations_per_s, 1) + " evaluations/s, " + durationText(report.remaining_s) + " left";
}

std::string workersText(const std::vector<WorkerStatus>& workers)
{
  std::map<std::string, HostWork> hosts;
  HostWork all;
  int64_t checked = 0;
  for (const WorkerStatus& worker : workers)
  {
    for (HostWork* const work : { &hosts[worker.host], &all })
    {
      work->usable += worker.usable() ? 1 : 0;
      work->evaluations += worker.evaluations;
    }
    checked += worker.checked;
  }
  if (workers.empty())
  {
    return "";
  }
  std::string text = "Simulators: " + toText(all.usable) + " at work; " + counted(all.evaluations, "evaluation") +
                     ", of which " + toText(checked) + " checked\n";
  for (const auto& [host, work] : hosts)
  {
    text +=
        "    host " + host + ": " + toText(work.usable) + " at work, " + counted(work.evaluations, "evaluation") + "\n";
  }
  constexpr int64_t most_named = 20;
  int64_t in_trouble = 0;
  for (const WorkerStatus& worker : workers)
  {
    if (inTrouble(worker) && ++in_trouble <= most_named)
    {
      text += "    " + worker.name + " (host " + worker.host + ", " + counted(worker.evaluations, "evaluation") + ") " +
              stateText(worker) + "\n";
    }
  }
  if (in_trouble > most_named)
  {
    text += "    and " + toText(in_trouble - most_named) + " more that are late, lost, refused or quarantined\n";
  }
  return text;
}

std::string resultsText(const Archive& archive, const std::string& output)
{
  const auto best = bestChampion(archive);
  return "Results:    " + archivePath(output) + "\n" +
         (best ? describe(*best, *makeBody(archive.settings().body)) : "Best robot: none is valid yet\n") +
         "Digest:     " + archive.digest() + "\n";
}
}  // namespace devo_evo
