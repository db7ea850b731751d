#pragma once

#include "archive/test_tools.h"
#include "devo_evo/study/study.h"

#include <algorithm>
#include <deque>
#include <string>
#include <vector>

namespace devo_evo::test
{
/// Answers at once, by what madeUpEvaluation() says; uphill everybody is slower.
class MadeUpFarm : public Farm
{
public:
  explicit MadeUpFarm(const SoftBodySettings& body) : slope_(body.slope) {}

  void submit(std::vector<EvaluationRequest> requests) override
  {
    for (const EvaluationRequest& request : requests)
    {
      Evaluation evaluation = madeUpEvaluation(request.program);
      evaluation.fitness -= slope_;
      results_.push_back({ request.trial, request.id, evaluation, "test" });
    }
  }

  std::vector<EvaluationResult> collect(std::chrono::milliseconds /*timeout*/) override
  {
    std::vector<EvaluationResult> few;
    for (int i = 0; i < 7 && !results_.empty(); ++i)
    {
      few.push_back(std::move(results_.front()));
      results_.pop_front();
    }
    return few;
  }

  std::vector<WorkerStatus> status() const override { return {}; }

private:
  const double slope_;
  std::deque<EvaluationResult> results_;
};

/// Remembers what was said; stops the study after it was asked a number of times.
class CountingObserver : public StudyObserver
{
public:
  explicit CountingObserver(int64_t patience = INT64_MAX) : patience_(patience) {}

  void say(const std::string& line) override { said_ += line + "\n"; }
  void showProgress(const std::string& /*line*/) override {}
  bool stopRequested() override { return --patience_ <= 0; }

  const std::string& said() const { return said_; }

private:
  int64_t patience_;
  std::string said_;
};

/// A study of two trials of a few small robots.
inline Parameters smallStudy(const std::string& output)
{
  Parameters parameters;
  parameters.experiment = smallExperiment(output);
  parameters.experiment.trials = 2;
  parameters.experiment.generations = 6;
  StudySettings& study = parameters.study;
  study.only = partsOf(study);  // but quadrupeds, which MadeUpFarm does not know
  study.only.erase(std::remove(study.only.begin(), study.only.end(), StudyPart::RIGID), study.only.end());
  study.baseline_trials = 1;
  study.baseline_generations = 3;
  study.sweep_trials = 1;
  study.sweep_generations = 2;
  study.sweep_48ths = { 1, 48 };
  study.walks = 2;
  study.walk_steps = 5;
  study.neutral_lineages = 3;
  study.impact_reproductions = 50;
  study.friction_factors = { 0.5 };
  study.gravity_factors = {};
  study.amplitude_factors = {};
  study.slopes = { -0.5, 0.5 };
  return parameters;
}

/// Runs it on made-up evaluations. @return what it said.
inline std::string runSmall(const Parameters& parameters, RunOutcome expected = RunOutcome::FINISHED,
                            int64_t patience = INT64_MAX)
{
  CountingObserver observer(patience);
  const auto make_farm = [](const BodySettings& body) { return std::make_unique<MadeUpFarm>(body.soft); };
  const RunOutcome outcome = runStudy(parameters, someProvenance(), make_farm, observer);
  return outcome == expected ? observer.said() : "not the outcome that was expected\n" + observer.said();
}

inline SQLite::Database openStudy(const std::string& output)
{
  return SQLite::Database(output + "/study.db", SQLite::OPEN_READONLY, 5000);
}

/// The only value of a query on study.db.
inline double valueOf(const std::string& output, const std::string& sql)
{
  return openStudy(output).execAndGet(sql).getDouble();
}

/// All that study.db says, but for when and where it was made.
inline std::string contentOfStudy(const std::string& output)
{
  SQLite::Database database = openStudy(output);
  std::string text;
  for (const std::string table : { "arms", "champions", "worlds", "variants", "walk_steps", "ancestors",
                                   "neutral_lineages", "traces", "robustness", "mutational_impact",
                                   "(SELECT world, hex(phenotype_hash), valid, fitness, turns, hex(state_hash), "
                                   "hex(velocities) FROM evaluations)" })
  {
    SQLite::Statement rows(database, "SELECT * FROM " + table + " ORDER BY 1, 2, 3, 4, 5");
    text += table + "\n";
    while (rows.executeStep())
    {
      for (int column = 0; column < rows.getColumnCount(); ++column)
      {
        text += rows.getColumn(column).getString() + "|";
      }
      text += "\n";
    }
  }
  return text;
}
}  // namespace devo_evo::test
