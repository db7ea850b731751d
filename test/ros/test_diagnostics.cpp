#include "ros/diagnostics.h"

#include <gtest/gtest.h>

namespace devo_evo
{
namespace
{
using diagnostic_msgs::DiagnosticStatus;

ExperimentStatus running()
{
  ExperimentStatus status;
  status.output = "/data/evo";
  status.trials = 2;
  status.trials_finished = 1;
  status.generations = 20;
  status.generations_committed = 30;
  status.total_evaluations = 900;
  status.evaluations_per_s = 12.5;
  return status;
}

DiagnosticStatus experimentStatus(const ExperimentStatus& experiment, const std::vector<WorkerStatus>& workers)
{
  return diagnosticsOf("/evolver", experiment, workers).status.at(0);
}

std::string valueOf(const DiagnosticStatus& status, const std::string& key)
{
  for (const auto& entry : status.values)
  {
    if (entry.key == key)
    {
      return entry.value;
    }
  }
  return "(none)";
}

const WorkerStatus BUSY = { "/simulator_1", "host1", WorkerState::WORKING, "", 450, 2, 0, "", "", "" };

TEST(Diagnostics, TellHowTheExperimentIsDoing)
{
  const DiagnosticStatus status = experimentStatus(running(), { BUSY });
  EXPECT_EQ(status.name, "/evolver: experiment");
  EXPECT_EQ(status.level, DiagnosticStatus::OK);
  EXPECT_EQ(status.message, "evolving");
  EXPECT_EQ(valueOf(status, "output"), "/data/evo");
  EXPECT_EQ(valueOf(status, "generations committed"), "30");
  EXPECT_EQ(valueOf(status, "evaluations per second"), "12.5");
  EXPECT_EQ(valueOf(status, "usable simulators"), "1");
}

TEST(Diagnostics, WarnWithoutSimulatorsAndWhilePaused)
{
  EXPECT_EQ(experimentStatus(running(), {}).level, DiagnosticStatus::WARN);
  EXPECT_EQ(experimentStatus(running(), {}).message, "waiting for a simulator");
  ExperimentStatus paused = running();
  paused.paused = true;
  EXPECT_EQ(experimentStatus(paused, { BUSY }).level, DiagnosticStatus::WARN);
  EXPECT_EQ(experimentStatus(paused, { BUSY }).message, "paused");
}

TEST(Diagnostics, AFinishedExperimentNeedsNoSimulator)
{
  ExperimentStatus finished = running();
  finished.trials_finished = 2;
  EXPECT_EQ(experimentStatus(finished, {}).level, DiagnosticStatus::OK);
  EXPECT_EQ(experimentStatus(finished, {}).message, "finished");
}

TEST(Diagnostics, TellHowAStudyIsDoing)
{
  const StudyStatus study = { "/data/study", "quick", "walks", 3, 9, "walks: 7/90" };
  const auto running = diagnosticsOf("/study", study, std::vector<WorkerStatus>{ BUSY }).status;
  ASSERT_EQ(running.size(), 2u);
  EXPECT_EQ(running[0].name, "/study: study");
  EXPECT_EQ(running[0].level, DiagnosticStatus::OK);
  EXPECT_EQ(running[0].message, "running walks");
  EXPECT_EQ(valueOf(running[0], "number of the part"), "3 of 9");
  EXPECT_EQ(valueOf(running[0], "progress"), "walks: 7/90");
  EXPECT_EQ(valueOf(running[0], "usable simulators"), "1");
  EXPECT_EQ(running[1].name, "/study: simulator /simulator_1");
  const auto waiting = diagnosticsOf("/study", study, std::vector<WorkerStatus>()).status.at(0);
  EXPECT_EQ(waiting.level, DiagnosticStatus::WARN);
  EXPECT_EQ(waiting.message, "waiting for a simulator");
  EXPECT_EQ(diagnosticsOf("/study", study, std::nullopt).status.at(0).level, DiagnosticStatus::OK);
}

TEST(Diagnostics, TellOfEverySimulator)
{
  const auto status =
      diagnosticsOf("/evolver", running(),
                    { BUSY,
                      { "/simulator_2", "host2", WorkerState::LOST, "no sign of life for 5 s", 3, 0, 1, "", "", "" },
                      { "/simulator_3", "host3", WorkerState::REFUSED, "another engine", 0, 0, 0, "", "", "" },
                      { "/simulator_4", "host4", WorkerState::LATE, "no answer for 3 s", 8, 1, 0, "", "", "" },
                      { "/simulator_5", "host5", WorkerState::QUARANTINED, "wrong", 9, 1, 0, "", "", "" } })
          .status;
  ASSERT_EQ(status.size(), 6u);
  EXPECT_EQ(status[1].name, "/evolver: simulator /simulator_1");
  EXPECT_EQ(status[1].level, DiagnosticStatus::OK);
  EXPECT_EQ(valueOf(status[1], "evaluations"), "450");
  EXPECT_EQ(valueOf(status[1], "evaluations checked"), "2");
  EXPECT_EQ(status[2].level, DiagnosticStatus::WARN);
  EXPECT_EQ(status[2].message, "lost: no sign of life for 5 s");
  EXPECT_EQ(valueOf(status[2], "times lost"), "1");
  EXPECT_EQ(valueOf(status[2], "host"), "host2");
  EXPECT_EQ(status[3].level, DiagnosticStatus::ERROR);
  EXPECT_EQ(status[3].message, "refused: another engine");
  EXPECT_EQ(status[4].level, DiagnosticStatus::WARN);
  EXPECT_EQ(status[4].message, "late: no answer for 3 s");
  EXPECT_EQ(status[5].level, DiagnosticStatus::ERROR);
}

TEST(Diagnostics, ReportsOfGenerationsCountSimulators)
{
  const auto in = [](WorkerState state) { return WorkerStatus{ "/s", "host", state, "", 0, 0, 0, "", "", "" }; };
  GenerationSummary summary;
  countSimulators({ in(WorkerState::IDLE), in(WorkerState::WORKING), in(WorkerState::LATE), in(WorkerState::LOST),
                    in(WorkerState::CONNECTING), in(WorkerState::REFUSED), in(WorkerState::QUARANTINED) },
                  summary);
  EXPECT_EQ(summary.simulators, 3);
  EXPECT_EQ(summary.simulators_late, 1);
  EXPECT_EQ(summary.simulators_lost, 1);
  EXPECT_EQ(summary.simulators_rejected, 2);
}
}  // namespace
}  // namespace devo_evo
