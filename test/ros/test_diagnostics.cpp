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

const WorkerStatus BUSY = { "/simulator_1", "working", true, 450 };

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

TEST(Diagnostics, TellOfEverySimulator)
{
  const auto status = diagnosticsOf("/evolver", running(),
                                    { BUSY,
                                      { "/simulator_2", "lost: no sign of life for 5 s", false, 3 },
                                      { "/simulator_3", "refused: another engine", false, 0 } })
                          .status;
  ASSERT_EQ(status.size(), 4u);
  EXPECT_EQ(status[1].name, "/evolver: simulator /simulator_1");
  EXPECT_EQ(status[1].level, DiagnosticStatus::OK);
  EXPECT_EQ(valueOf(status[1], "evaluations"), "450");
  EXPECT_EQ(status[2].level, DiagnosticStatus::WARN);
  EXPECT_EQ(status[2].message, "lost: no sign of life for 5 s");
  EXPECT_EQ(status[3].level, DiagnosticStatus::ERROR);
}
}  // namespace
}  // namespace devo_evo
