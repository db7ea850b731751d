#include "cli/tool_process.h"

#include "devo_evo/experiment/json_lines.h"
#include "devo_evo/bodies/bodies.h"
#include "devo_evo/soft_body/simulation.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sstream>

#include <sys/stat.h>

namespace devo_evo
{
namespace
{
using Json = nlohmann::json;

const std::string REFERENCE = TEST_DATA_DIR "/genomes.jsonl";

/// The first robots of the reference, a line each.
std::string referenceLines(int count)
{
  std::ifstream file(REFERENCE);
  std::string lines, line;
  for (int i = 0; i < count && std::getline(file, line); ++i)
  {
    lines += line + "\n";
  }
  return lines;
}

std::vector<Json> parseLines(const std::string& text)
{
  std::vector<Json> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
  {
    lines.push_back(Json::parse(line));
  }
  return lines;
}

/// Arguments that make the simulations short.
std::vector<std::string> quickly(std::vector<std::string> arguments)
{
  arguments.insert(arguments.begin(), "evaluate");
  arguments.insert(arguments.end(), { "--lifetime", "0.6" });
  return arguments;
}

TEST(EvaluateCommand, EvaluatesEveryRobotInOrder)
{
  const TemporaryFolder folder;
  const std::string out = folder.file("results.jsonl");
  const ToolResult result = runTool({ "evaluate", REFERENCE, "--out", out, "--lifetime", "0.01" });
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out + result.err, "");
  const auto results = parseLines(contentOf(out));
  const auto robots = parseLines(contentOf(REFERENCE));
  ASSERT_EQ(results.size(), robots.size());
  for (size_t i = 0; i < robots.size(); ++i)
  {
    EXPECT_EQ(results[i]["id"], robots[i]["id"]);
  }
}

TEST(EvaluateCommand, WritesWhatTheLibraryComputes)
{
  const std::string lines = referenceLines(3);
  const auto results = parseLines(runTool(quickly({ "-" }), lines).out);
  SoftBodySettings settings;
  settings.lifetime = 0.6;
  std::istringstream input(lines);
  RobotReader reader(input, "reference", *makeSoftBody(settings));
  ASSERT_EQ(results.size(), 3u);
  for (const Json& result : results)
  {
    const Evaluation expected = evaluate(settings, { reader.next()->genome.program }).front();
    EXPECT_EQ(result["valid"], true);
    EXPECT_EQ(result["fitness"].get<double>(), expected.fitness);
    EXPECT_EQ(result["displacement_y_voxels"].get<double>(), expected.displacement_y_voxels);
    EXPECT_EQ(result["velocity_body_lengths_per_s"].get<std::vector<double>>(), expected.velocity_body_lengths_per_s);
    EXPECT_EQ(result["state_hash"].get<std::string>(), hashToString(expected.state_hash));
  }
}

TEST(EvaluateCommand, GivesTheSameOnAnyNumberOfThreadsAndInstructions)
{
  const std::string lines = referenceLines(13);
  const std::string expected = runTool(quickly({ "-", "--threads", "1", "--instruction_set", "scalar" }), lines).out;
  EXPECT_EQ(parseLines(expected).size(), 13u);
  EXPECT_EQ(runTool(quickly({ "-", "--threads", "2" }), lines).out, expected);
  EXPECT_EQ(runTool(quickly({ "-", "--threads", "5" }), lines).out, expected);
}

TEST(EvaluateCommand, TakesPhysicsFromOptionsAndFiles)
{
  const TemporaryFolder folder;
  std::ofstream(folder.file("moon.yaml")) << "gravity: 1.62\nlifetime: 0.3\n";
  const std::string robot = referenceLines(1);
  const auto by_file = runTool({ "evaluate", "-", "--config", folder.file("moon.yaml") }, robot);
  const auto by_options = runTool({ "evaluate", "-", "--gravity=1.62", "--lifetime", "0.3" }, robot);
  const auto on_earth = runTool({ "evaluate", "-", "--config", folder.file("moon.yaml"), "--gravity", "9.81" }, robot);
  EXPECT_EQ(by_file.status, 0) << by_file.err;
  EXPECT_EQ(by_file.out, by_options.out);
  EXPECT_NE(by_file.out, on_earth.out);
}

TEST(EvaluateCommand, AnswersADivergingRobotWithItsVerdict)
{
  const auto result = runTool(quickly({ "-", "--bond_damping", "10" }), referenceLines(2));
  EXPECT_EQ(result.status, 0) << result.err;
  for (const Json& robot : parseLines(result.out))
  {
    EXPECT_EQ(robot["valid"], false);
    EXPECT_TRUE(robot["fitness"].is_null());
    EXPECT_GT(robot["verdict"]["step"].get<int64_t>(), 0);
    EXPECT_NE(robot["verdict"]["message"].get<std::string>().find("diverged at step"), std::string::npos);
  }
}

TEST(EvaluateCommand, ReadsEveryRobotBeforeItSimulatesOne)
{
  const TemporaryFolder folder;
  const std::string out = folder.file("results.jsonl");
  std::ofstream(out) << "earlier results\n";
  const auto result = runTool(quickly({ "-", "--out", out }), referenceLines(2) + "{\"id\": 3, oops}\n");
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.err.rfind("devo_evo: error: standard input, line 3, column 11: malformed JSON", 0), 0u)
      << result.err;
  EXPECT_EQ(contentOf(out), "earlier results\n");
}

TEST(EvaluateCommand, NamesTheGeneThatIsWrong)
{
  Json robot = Json::parse(referenceLines(1));
  robot["phase_initial_cycles"][17] = 1.5;
  EXPECT_EQ(runTool(quickly({ "-" }), robot.dump()).err,
            "devo_evo: error: standard input, line 1, robot \"golden-000\": phase_initial[17] is 1.5; it must lie "
            "within -1 to 1\n");
}

TEST(EvaluateCommand, WarnsOfRobotsOfTheSameNameAndOfNone)
{
  const auto twice = runTool(quickly({ "-" }), referenceLines(1) + referenceLines(1));
  EXPECT_EQ(twice.status, 0);
  EXPECT_EQ(parseLines(twice.out).size(), 2u);
  EXPECT_NE(twice.err.find("warning: standard input, line 2: an earlier robot is called \"golden-000\" too"),
            std::string::npos)
      << twice.err;
  const auto none = runTool(quickly({ "-" }), "\n");
  EXPECT_EQ(none.status, 0);
  EXPECT_EQ(none.out, "");
  EXPECT_NE(none.err.find("there is no robot"), std::string::npos) << none.err;
}

TEST(EvaluateCommand, RefusesInputThatCannotBeRead)
{
  const TemporaryFolder folder;
  const auto missing = runTool({ "evaluate", folder.file("missing.jsonl") });
  EXPECT_EQ(missing.status, 2);
  EXPECT_NE(missing.err.find("missing.jsonl: it cannot be read: No such file"), std::string::npos) << missing.err;
  EXPECT_EQ(runTool({ "evaluate", folder.file("") }).status, 2);
}

TEST(EvaluateCommand, TakesAPipe)
{
  const TemporaryFolder folder;
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  ToolProcess tool(quickly({ pipe }));
  std::ofstream(pipe) << referenceLines(2);
  EXPECT_EQ(tool.finish(), 0) << tool.err();
  EXPECT_EQ(parseLines(tool.out()).size(), 2u);
}

TEST(EvaluateCommand, FailsIfResultsCannotBeWritten)
{
  const TemporaryFolder folder;
  const std::string robots = referenceLines(2);
  const auto nowhere = runTool(quickly({ "-", "--out", folder.file("missing/results.jsonl") }), robots);
  EXPECT_EQ(nowhere.status, 1);
  EXPECT_NE(nowhere.err.find("missing/results.jsonl cannot be opened: No such file"), std::string::npos) << nowhere.err;
  const auto full = runTool(quickly({ "-", "--out", "/dev/full" }), robots);
  EXPECT_EQ(full.status, 1);
  EXPECT_EQ(full.err, "devo_evo: error: /dev/full cannot be written: No space left on device\n");
}

TEST(EvaluateCommand, DoesNotOverwriteItsInput)
{
  const TemporaryFolder folder;
  const std::string file = folder.file("robots.jsonl");
  std::ofstream(file) << referenceLines(1);
  const auto result = runTool(quickly({ file, "--out", file }));
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(contentOf(file), referenceLines(1));
}

TEST(EvaluateCommand, StopsAtOnceAndKeepsWhatIsDone)
{
  const TemporaryFolder folder;
  ToolProcess tool({ "evaluate", REFERENCE, "--lifetime", "1000", "--out", folder.file("results.jsonl") });
  while (!std::filesystem::exists(folder.file("results.jsonl")))
  {
    usleep(1000);
  }
  tool.signal(SIGINT);
  EXPECT_EQ(tool.finish(), 128 + SIGINT);
  EXPECT_NE(tool.err().find("stopped by SIGINT"), std::string::npos) << tool.err();
}
}  // namespace
}  // namespace devo_evo
