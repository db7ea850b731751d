// The tool with rigid bodies: what works as for soft ones, and what says that it does not.

#include "cli/tool_process.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace devo_evo
{
namespace
{
using Words = std::vector<std::string>;
using Json = nlohmann::json;

ToolResult evolve(const std::string& output, const Words& more = {})
{
  Words words = { "evolve", "--output",     output, "--body",        "rigid", "--rigid_lifetime",
                  "0.5",    "--population", "4",    "--generations", "2" };
  words.insert(words.end(), more.begin(), more.end());
  return runTool(words);
}

class RigidTool : public testing::Test
{
protected:
  RigidTool() : output_(folder_.file("output"))
  {
    const ToolResult result = evolve(output_);
    EXPECT_EQ(result.status, 0) << result.err;
    said_ = result.out;
  }

  /// What a command says that cannot be done, with exit status 2 or 1.
  std::string refusal(const Words& words)
  {
    const ToolResult result = runTool(words);
    EXPECT_NE(result.status, 0);
    return result.err;
  }

  const TemporaryFolder folder_;
  const std::string output_;
  std::string said_;
};

TEST_F(RigidTool, SaysWhatTheBestRobotDidInItsOwnUnits)
{
  EXPECT_NE(said_.find("saw light of 0.00"), std::string::npos) << said_;
  EXPECT_NE(said_.find(" m down the slope in 0.5 s"), std::string::npos) << said_;
}

TEST_F(RigidTool, VerifiesAndComparesItsArchives)
{
  const ToolResult verified = runTool({ "verify", output_, "--all" });
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
  const std::string other = folder_.file("other");
  EXPECT_EQ(evolve(other, { "--threads", "1" }).status, 0);
  EXPECT_EQ(runTool({ "digest", output_ }).out, runTool({ "digest", other }).out);
  EXPECT_EQ(runTool({ "diff", output_, other }).status, 0);
}

TEST_F(RigidTool, ExportsRobotsThatItEvaluatesAndImportsAgain)
{
  const std::string robot = folder_.file("robot.jsonl");
  EXPECT_EQ(runTool({ "export", output_, "--individual", "1", "--out", robot }).status, 0);
  const ToolResult evaluated = runTool({ "evaluate", robot, "--body", "rigid", "--rigid_lifetime", "0.5" });
  ASSERT_EQ(evaluated.status, 0) << evaluated.err;
  const Json evaluation = Json::parse(evaluated.out);
  const Json info = Json::parse(runTool({ "info", output_, "--json" }).out);
  EXPECT_EQ(evaluation["fitness"], info["trials"][0]["fitness"]);
  EXPECT_TRUE(evaluation.contains("leg_contact"));
  const ToolResult imported = runTool({ "import", robot, "--body", "rigid" });
  EXPECT_EQ(imported.status, 0) << imported.err;
  std::ifstream file(robot);
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(imported.out, line + "\n");
}

TEST_F(RigidTool, RefusesRobotsOfTheOtherBody)
{
  const std::string robot = folder_.file("robot.jsonl");
  EXPECT_EQ(runTool({ "export", output_, "--individual", "1", "--out", robot }).status, 0);
  EXPECT_NE(refusal({ "evaluate", robot }).find("body is \"rigid\", and the parameter body is soft"),
            std::string::npos);
  EXPECT_NE(refusal({ "import", robot }).find("body is \"rigid\", and the parameter body is soft"), std::string::npos);
}

TEST_F(RigidTool, SaysWhatIsForSoftBodiesOnly)
{
  EXPECT_NE(refusal({ "export", output_, "--individual", "1", "--format", "vxa" })
                .find("VXA files can have soft bodies only; body is rigid"),
            std::string::npos);
  EXPECT_NE(refusal({ "evolve", "--output", folder_.file("new"), "--body", "rigid", "--grid", "2x2x2" })
                .find("grid is 2x2x2, but it is a parameter of soft bodies"),
            std::string::npos);
}
}  // namespace
}  // namespace devo_evo
