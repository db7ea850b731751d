#include "devo_evo/experiment/report_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>

namespace devo_evo
{
namespace
{
TEST(FixedText, HasTheDecimalsAskedFor)
{
  EXPECT_EQ(fixedText(1.0, 2), "1.00");
  EXPECT_EQ(fixedText(-12.3456, 3), "-12.346");
  EXPECT_EQ(fixedText(0.5, 0), "0");
  EXPECT_EQ(fixedText(1e300, 1).size(), 303u);
  EXPECT_EQ(fixedText(std::nan(""), 3), "-");
  EXPECT_EQ(fixedText(-std::numeric_limits<double>::infinity(), 3), "-");
}

TEST(DurationText, ShowsTheTwoLargestUnits)
{
  EXPECT_EQ(durationText(0.4), "0 s");
  EXPECT_EQ(durationText(42.0), "42 s");
  EXPECT_EQ(durationText(59.7), "1 min 0 s");
  EXPECT_EQ(durationText(185.0), "3 min 5 s");
  EXPECT_EQ(durationText(2 * 3600.0 + 10 * 60.0), "2 h 10 min");
  EXPECT_EQ(durationText(4 * 86400.0 + 3 * 3600.0), "4 d 3 h");
  EXPECT_EQ(durationText(std::nan("")), "unknown");
  EXPECT_EQ(durationText(std::numeric_limits<double>::infinity()), "unknown");
}

TEST(ProgressText, SaysHowFarAndHowFast)
{
  ExperimentSettings settings;
  settings.trials = 3;
  GenerationRecord record;
  record.trial = 2;
  record.generation = 7;
  record.best_fitness = 1.25;
  record.median_fitness = std::nan("");
  const Individual champion;
  EXPECT_EQ(progressText({ record, champion, 30, 240, 58.25, 125.0 }, settings),
            "trial 2/3, generation 7/20: best 1.250, median - body lengths; 58.2 evaluations/s, 2 min 5 s left");
}

/// A robot of two voxels that travels as far as its gene says; invalid if that is not finite.
Individual robot(int64_t trial, double fitness)
{
  Individual individual;
  individual.trial = trial;
  individual.genome.program = { { 0.5, 0.5 }, { 0.0, 0.0 }, { 0.0, 0.0 }, { 0.125, 0.0 } };
  individual.genome.mutation_rate = { 0.5, 0.5 };
  Evaluation evaluation;
  evaluation.valid = std::isfinite(fitness);
  if (evaluation.valid)
  {
    evaluation.fitness = evaluation.displacement_y_voxels = evaluation.displacement_xy_voxels = fitness;
    evaluation.turns = 1.5;
    evaluation.airborne_fraction = 0.0;
    evaluation.fell_over_since_birth_s = 2.25;
    evaluation.state_hash = 1;
  }
  else
  {
    evaluation.divergence = Divergence{ 1, 0, 101.0 };
  }
  individual.evaluation = evaluation;
  return individual;
}

class ResultsText : public ::testing::Test
{
protected:
  ResultsText()
  {
    std::string pattern = ::testing::TempDir() + "devo_evo_XXXXXX";
    settings_.output = mkdtemp(pattern.data());
    settings_.body.soft.grid_x = 2;
    settings_.body.soft.grid_y = settings_.body.soft.grid_z = 1;
    archive_ = openArchiveForWriting(settings_, Provenance());
  }

  ~ResultsText() override { std::filesystem::remove_all(settings_.output); }

  void commit(int64_t trial, double fitness)
  {
    GenerationRecord record;
    record.trial = trial;
    record.newcomers = { robot(trial, fitness) };
    record.survivors = { 0 };
    archive_->commitGeneration(record);
  }

  ExperimentSettings settings_;
  std::unique_ptr<Archive> archive_;
};

TEST_F(ResultsText, DescribesTheBestRobotOfAllTrials)
{
  commit(1, 2.0);
  commit(2, 3.5);
  commit(3, std::nan(""));
  EXPECT_EQ(resultsText(*archive_, settings_.output),
            "Results:    " + settings_.output + "/experiment.db\n" +
                "Best robot: 2/0, born in generation 0\n"
                "    travelled 3.500 body lengths in 10 s, made 1.50 turns, fell over 2.25 s after birth\n"
                "    developmental windows: W_L 0.250 (body), W_Phi 0.125 (control)\n"
                "Digest:     " +
                archive_->digest() + "\n");
}

TEST_F(ResultsText, SaysIfThereIsNoBestRobot)
{
  commit(1, std::nan(""));
  EXPECT_NE(resultsText(*archive_, settings_.output).find("Best robot: none is valid yet\n"), std::string::npos);
}

TEST(ReportText, SaysWhoWorkedWhereAndWhoDidNot)
{
  const std::vector<WorkerStatus> workers = {
    { "/s1", "alpha", WorkerState::WORKING, "", 1000, 5, 0, "", "", "" },
    { "/s2", "alpha", WorkerState::IDLE, "", 200, 1, 0, "", "", "" },
    { "/s3", "beta", WorkerState::LOST, "no sign of life for 5 s", 1, 0, 1, "", "", "" },
    { "/s4", "beta", WorkerState::QUARANTINED, "wrong", 8, 0, 0, "", "", "" }
  };
  EXPECT_EQ(workersText(workers),
            "Simulators: 2 at work; 1209 evaluations, of which 6 checked\n"
            "    host alpha: 2 at work, 1200 evaluations\n"
            "    host beta: 0 at work, 9 evaluations\n"
            "    /s3 (host beta, 1 evaluation) lost: no sign of life for 5 s\n"
            "    /s4 (host beta, 8 evaluations) quarantined: wrong\n");
  EXPECT_EQ(workersText({}), "");
}
}  // namespace
}  // namespace devo_evo
