#include "farm/work_ledger.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace devo_evo
{
namespace
{
const Evaluation& evaluationWith(uint64_t hash)
{
  static std::map<uint64_t, Evaluation> evaluations;
  Evaluation& evaluation = evaluations[hash];
  evaluation.valid = true;
  evaluation.fitness = evaluation.displacement_y_voxels = evaluation.displacement_xy_voxels = 1.0;
  evaluation.turns = evaluation.airborne_fraction = 0.0;
  evaluation.state_hash = hash;
  return evaluation;
}

const uint64_t RIGHT = 7;
const uint64_t WRONG = 8;

std::vector<EvaluationRequest> robots(int64_t count, int64_t trial = 1)
{
  std::vector<EvaluationRequest> requests;
  for (int64_t id = 0; id < count; ++id)
  {
    requests.push_back({ trial, id, {} });
  }
  return requests;
}

class WorkLedgerTest : public testing::Test
{
protected:
  /// Lets a worker take up to `most` robots. @return how many it took.
  size_t take(const std::string& worker, size_t most = 100)
  {
    taken_[worker] = ledger_.take(worker, most).size();
    return taken_[worker];
  }

  void deliver(const std::string& worker, uint64_t hash = RIGHT)
  {
    ledger_.deliver(worker, std::vector<Evaluation>(taken_[worker], evaluationWith(hash)));
  }

  void judge(uint64_t hash)
  {
    const auto [number, request] = ledger_.takeAsReferee();
    ledger_.judge(number, evaluationWith(hash));
  }

  /// Those who were found wrong since the last call, in order and once each.
  std::set<std::string> liars()
  {
    std::set<std::string> names;
    for (const Comparison& comparison : ledger_.takeComparisons())
    {
      if (!comparison.agrees)
      {
        names.insert(comparison.worker);
      }
    }
    return names;
  }

  void expectResults(size_t count, uint64_t hash = RIGHT)
  {
    const auto results = ledger_.takeResults();
    EXPECT_EQ(results.size(), count);
    for (const EvaluationResult& result : results)
    {
      EXPECT_EQ(result.evaluation.state_hash, hash) << result.trial << "/" << result.id << " by " << result.worker;
    }
  }

  void useFraction(double checked_fraction) { ledger_ = WorkLedger(checked_fraction); }

  WorkLedger ledger_{ 0.0 };
  std::map<std::string, size_t> taken_;
};

TEST_F(WorkLedgerTest, ResultsOfAGroupComeOutTogether)
{
  ledger_.submit(robots(3, 1));
  ledger_.submit(robots(2, 2));
  EXPECT_EQ(take("a", 2), 2u);
  EXPECT_EQ(take("b", 3), 3u);
  deliver("a");
  EXPECT_FALSE(ledger_.hasResults());
  deliver("b");
  expectResults(5);
  EXPECT_TRUE(ledger_.takeResults().empty());
}

TEST_F(WorkLedgerTest, TheSecondGroupDoesNotWaitForTheFirst)
{
  ledger_.submit(robots(1, 1));
  ledger_.submit(robots(1, 2));
  take("a", 1);
  take("b", 1);
  deliver("b");
  const auto results = ledger_.takeResults();
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results[0].trial, 2);
  EXPECT_EQ(results[0].worker, "b");
}

TEST_F(WorkLedgerTest, WhatAWorkerGivesUpGoesToOthersFirst)
{
  ledger_.submit(robots(3));
  take("a", 2);
  EXPECT_EQ(ledger_.giveUp("a"), 2u);
  const auto again = ledger_.take("b", 3);
  ASSERT_EQ(again.size(), 3u);
  EXPECT_EQ(again[0].id, 0);
  EXPECT_EQ(again[1].id, 1);
  EXPECT_EQ(ledger_.giveUp("nobody"), 0u);
}

TEST_F(WorkLedgerTest, TheFractionOfRobotsThatIsCheckedIsTheOneAskedFor)
{
  useFraction(0.005);
  ledger_.submit(robots(100000));
  const auto second_evaluations = static_cast<double>(ledger_.waiting()) - 100000.0;
  EXPECT_NEAR(second_evaluations, 500.0, 4.0 * 22.4) << "binomial: standard deviation sqrt(100000 * 0.005 * 0.995)";
}

TEST_F(WorkLedgerTest, WhichRobotsAreCheckedDependsOnTheirNamesOnly)
{
  useFraction(0.5);
  ledger_.submit(robots(1000));
  const size_t together = ledger_.waiting();
  useFraction(0.5);
  for (const EvaluationRequest& robot : robots(1000))
  {
    ledger_.submit({ robot });
  }
  EXPECT_EQ(ledger_.waiting(), together);
}

TEST_F(WorkLedgerTest, ARobotIsCheckedByTwoDifferentWorkers)
{
  useFraction(1.0);
  ledger_.submit(robots(3));
  EXPECT_EQ(take("a"), 3u);
  EXPECT_FALSE(ledger_.hasWorkFor("a"));
  deliver("a");
  EXPECT_FALSE(ledger_.hasWorkFor("a"));
  EXPECT_FALSE(ledger_.hasResults());
  ASSERT_TRUE(ledger_.hasWorkFor("b"));
  EXPECT_EQ(take("b"), 3u);
  deliver("b");
  EXPECT_FALSE(ledger_.hasWorkForReferee());
  expectResults(3);
  const auto comparisons = ledger_.takeComparisons();
  EXPECT_EQ(comparisons.size(), 6u) << "three of each worker";
  EXPECT_TRUE(std::all_of(comparisons.begin(), comparisons.end(), [](const Comparison& each) { return each.agrees; }));
}

TEST_F(WorkLedgerTest, WhereTwoDifferTheRefereeDecides)
{
  useFraction(1.0);
  ledger_.submit(robots(1));
  take("liar");
  take("honest");
  deliver("liar", WRONG);
  deliver("honest");
  ASSERT_TRUE(ledger_.hasWorkForReferee());
  EXPECT_FALSE(ledger_.hasResults());
  judge(RIGHT);
  const auto comparisons = ledger_.takeComparisons();
  ASSERT_EQ(comparisons.size(), 2u);
  EXPECT_EQ(comparisons[0].worker, "liar");
  EXPECT_FALSE(comparisons[0].agrees);
  EXPECT_EQ(comparisons[0].given.state_hash, WRONG);
  EXPECT_EQ(comparisons[0].right.state_hash, RIGHT);
  EXPECT_TRUE(comparisons[1].agrees);
  const auto results = ledger_.takeResults();
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results[0].evaluation.state_hash, RIGHT);
  EXPECT_EQ(results[0].worker, WorkLedger::REFEREE);
}

TEST_F(WorkLedgerTest, TheRefereeMayFindBothWrong)
{
  useFraction(1.0);
  ledger_.submit(robots(1));
  take("a");
  take("b");
  deliver("a", WRONG);
  deliver("b", WRONG + 1);
  judge(RIGHT);
  EXPECT_EQ(liars(), (std::set<std::string>{ "a", "b" }));
  expectResults(1);
}

TEST_F(WorkLedgerTest, AnEqualHashOverAnotherFitnessIsADifferenceToo)
{
  useFraction(1.0);
  ledger_.submit(robots(1));
  take("a");
  take("b");
  deliver("a");
  Evaluation other = evaluationWith(RIGHT);
  other.fitness = 2.0;
  ledger_.deliver("b", { other });
  EXPECT_TRUE(ledger_.hasWorkForReferee());
}

TEST_F(WorkLedgerTest, WhatALiarSaidInGroupsThatAreNotCompleteIsEvaluatedAgain)
{
  ledger_.submit(robots(2, 1));  // complete before the lie is noticed: out of reach
  take("liar");
  deliver("liar", WRONG);
  expectResults(2, WRONG);
  ledger_.submit(robots(3, 1));
  ledger_.submit(robots(3, 2));
  take("liar", 2);
  deliver("liar", WRONG);
  take("liar", 2);
  deliver("liar", WRONG);
  take("liar", 1);
  EXPECT_EQ(ledger_.distrust("liar"), 4u);
  EXPECT_FALSE(ledger_.hasResults());
  EXPECT_EQ(take("honest"), 6u) << "four void evaluations, one that was under way, one not begun";
  deliver("honest");
  expectResults(6);
}

TEST_F(WorkLedgerTest, WhatTheRefereeJudgedStands)
{
  useFraction(1.0);
  ledger_.submit(robots(2));
  take("liar");
  take("honest");
  deliver("liar", WRONG);
  deliver("honest");
  judge(RIGHT);
  EXPECT_EQ(ledger_.distrust("liar"), 1u) << "of the one that is not judged yet";
  judge(RIGHT);
  expectResults(2);
}

TEST_F(WorkLedgerTest, WithoutASecondWorkerTheRefereeChecks)
{
  useFraction(1.0);
  ledger_.submit(robots(2));
  ledger_.refer({});
  ledger_.refer({ "only" });
  EXPECT_FALSE(ledger_.hasWorkForReferee()) << "somebody may still join, and the only one has not evaluated them yet";
  take("only", 1);
  ledger_.refer({ "only" });
  ASSERT_TRUE(ledger_.hasWorkForReferee());
  judge(RIGHT);  // before the worker is done
  EXPECT_FALSE(ledger_.hasResults());
  deliver("only", WRONG);
  EXPECT_EQ(liars(), (std::set<std::string>{ "only" }));
  take("only", 1);
  deliver("only");
  ledger_.refer({ "only" });
  judge(RIGHT);
  EXPECT_TRUE(liars().empty());
  expectResults(2);
}

TEST_F(WorkLedgerTest, ASecondWorkerThatIsThereIsWaitedFor)
{
  useFraction(1.0);
  ledger_.submit(robots(1));
  take("a");
  ledger_.refer({ "a", "busy" });
  EXPECT_FALSE(ledger_.hasWorkForReferee());
  EXPECT_TRUE(ledger_.hasWorkFor("busy"));
}

TEST_F(WorkLedgerTest, WhatALateWorkerHasIsDoneByOthersToo)
{
  ledger_.submit(robots(2));
  take("late");
  ledger_.doAgain("late");
  EXPECT_FALSE(ledger_.hasWorkFor("late"));
  EXPECT_FALSE(ledger_.isSuperseded("late"));
  EXPECT_EQ(take("quick"), 2u);
  deliver("quick");
  EXPECT_TRUE(ledger_.isSuperseded("late"));
  expectResults(2);
  deliver("late", WRONG);  // nobody needs it any more
  EXPECT_TRUE(ledger_.takeResults().empty());
}

TEST_F(WorkLedgerTest, ALateWorkerMayStillBeFirst)
{
  ledger_.submit(robots(2));
  take("late");
  ledger_.doAgain("late");
  deliver("late");
  EXPECT_FALSE(ledger_.hasWorkFor("quick"));
  expectResults(2);
}

TEST_F(WorkLedgerTest, WhatComesTwiceIsCompared)
{
  ledger_.submit(robots(2));
  take("late", 1);
  ledger_.doAgain("late");
  take("quick", 1);
  deliver("quick");
  deliver("late", WRONG);
  ASSERT_TRUE(ledger_.hasWorkForReferee());
  judge(RIGHT);
  EXPECT_EQ(liars(), (std::set<std::string>{ "late" }));
  take("quick");
  deliver("quick");
  expectResults(2);
}

TEST_F(WorkLedgerTest, ALateWorkerThatIsGivenUpIsReplacedOnce)
{
  ledger_.submit(robots(2));
  take("late");
  ledger_.doAgain("late");
  EXPECT_EQ(ledger_.giveUp("late"), 2u);
  EXPECT_EQ(ledger_.waiting(), 2u);
}
}  // namespace
}  // namespace devo_evo
