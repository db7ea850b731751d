#include "cli/tool_process.h"

#include <gtest/gtest.h>

namespace devo_evo
{
namespace
{
const char* const QUADRUPEDS = PROJECT_DIR "/config/quadrupeds.jsonl";

ToolResult map(const std::vector<std::string>& more)
{
  std::vector<std::string> arguments = { "gait_map", QUADRUPEDS, "--rigid_lifetime", "0.5",
                                         "--random", "1",        "--steps",          "1" };
  arguments.insert(arguments.end(), more.begin(), more.end());
  return runTool(arguments);
}

TEST(ToolGaitMap, WritesALineForEachWorld)
{
  const ToolResult result = map({ "--slopes", "0,10", "--residuals", "0.02,0.05,0.08", "--threads", "2" });
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out.rfind("slope,leg_residual,evaluations,walking_fitness,", 0), 0u);
  // 8 known that do not develop and 1 random robot, with and without development, 2 passive ones, 1 + 1 + 2 steps of
  // the climbs.
  EXPECT_NE(result.out.find("\n0,0.02,24,"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("\n10,0.08,24,"), std::string::npos) << result.out;
  EXPECT_EQ(result.out, map({ "--slopes", "0,10", "--residuals", "0.02,0.05,0.08", "--threads", "1" }).out);
}

TEST(ToolGaitMap, RefusesWhatMakesNoSense)
{
  EXPECT_NE(map({ "--slopes", "50" }).err.find("rigid_slope is 50"), std::string::npos);
  EXPECT_NE(runTool({ "gait_map", QUADRUPEDS, "--random", "-1" }).err.find("random_robots is -1"), std::string::npos);
  EXPECT_EQ(runTool({ "gait_map", TEST_DATA_DIR "/genomes.jsonl" }).status, 2) << "those are soft";
}
}  // namespace
}  // namespace devo_evo
