#include "experiment/evaluator_tally.h"

#include <gtest/gtest.h>

namespace devo_evo
{
namespace
{
WorkerStatus simulator(const std::string& name, const std::string& host, const std::string& processor)
{
  WorkerStatus status;
  status.name = name;
  status.host = host;
  status.processor = processor;
  status.instruction_set = "avx2";
  status.version = "1.2.3";
  return status;
}

TEST(EvaluatorTally, countsByMachineWhoeverWorksOnIt)
{
  EvaluatorTally tally;
  tally.count("/sim_1");
  tally.count("/sim_2");
  tally.count("/sim_2");
  tally.count("/other");
  const auto first = tally.evaluators({ simulator("/sim_1", "a", "Engine"), simulator("/sim_2", "a", "Engine"),
                                        simulator("/other", "b", "Loom"), simulator("/idle", "c", "Abacus") });
  ASSERT_EQ(first.size(), 2u);
  EXPECT_EQ(first[0].host, "a");
  EXPECT_EQ(first[0].processor, "Engine");
  EXPECT_EQ(first[0].instruction_set, "avx2");
  EXPECT_EQ(first[0].version, "1.2.3");
  EXPECT_EQ(first[0].evaluations, 3);
  EXPECT_EQ(first[1].evaluations, 1);

  tally.count("/sim_3");
  const auto later = tally.evaluators({ simulator("/sim_3", "a", "Engine") });
  ASSERT_EQ(later.size(), 2u);  // also those that have gone
  EXPECT_EQ(later[0].evaluations, 4);
}

TEST(EvaluatorTally, doesNotListThreadsOfThisProgram)
{
  EvaluatorTally tally;
  tally.count("thread 1");
  EXPECT_TRUE(tally.evaluators({ simulator("thread 1", "", "") }).empty());
}
}  // namespace
}  // namespace devo_evo
