#include "cli/tool_process.h"

#include "devo_evo/archive/archive.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace devo_evo
{
namespace
{
using Words = std::vector<std::string>;

/// A small experiment that takes about a second.
Words smallExperiment(const std::string& output, const Words& more = {})
{
  Words words = { "evolve", "--output",      output, "--grid",   "2x2x2", "--lifetime", "0.02", "--population",
                  "6",      "--generations", "40",   "--trials", "2",     "--seed",     "3" };
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::string digestOf(const std::string& output)
{
  const ToolResult result = runTool({ "digest", output });
  EXPECT_EQ(result.status, 0) << result.err;
  return result.out;
}

/// Generations committed in all trials; 0 while there is no archive.
int64_t committedGenerations(const std::string& output)
{
  try
  {
    int64_t count = 0;
    for (const auto& state : openArchiveForReading(output)->trialStates())
    {
      count += state.second.generation + 1;
    }
    return count;
  }
  catch (const ArchiveError&)
  {
    return 0;
  }
}

/// Waits until more generations are committed; at most half a minute.
void waitForProgress(const std::string& output, int64_t generations)
{
  const int64_t wanted = committedGenerations(output) + generations;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (committedGenerations(output) < wanted && std::chrono::steady_clock::now() < deadline)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

class EvolveCommand : public ::testing::Test
{
protected:
  /// The digest of the small experiment, evolved on one thread without interruption.
  static void SetUpTestSuite()
  {
    const TemporaryFolder folder;
    const ToolResult result = runTool(smallExperiment(folder.file("reference"), { "--threads", "1" }));
    ASSERT_EQ(result.status, 0) << result.err;
    expected_digest_ = digestOf(folder.file("reference"));
  }

  const TemporaryFolder folder_;
  const std::string output_ = folder_.file("experiment");
  static std::string expected_digest_;
};

std::string EvolveCommand::expected_digest_;

TEST_F(EvolveCommand, GivesTheSameDigestOnTwoThreads)
{
  const ToolResult result = runTool(smallExperiment(output_, { "--threads", "2" }));
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(digestOf(output_), expected_digest_);
  EXPECT_EQ(expected_digest_.size(), 65u);  // 64 digits and the line's end
}

TEST_F(EvolveCommand, GivesTheSameDigestWithOtherInstructions)
{
  EXPECT_EQ(runTool(smallExperiment(output_, { "--instruction_set", "scalar" })).status, 0);
  EXPECT_EQ(digestOf(output_), expected_digest_);
}

TEST_F(EvolveCommand, TellsItsProgressAndItsResults)
{
  const ToolResult result = runTool(smallExperiment(output_));
  EXPECT_NE(result.err.find("evolving in " + output_ + "\n"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("trial 2/2, generation 40/40: best "), std::string::npos) << result.err;
  EXPECT_NE(result.err.find(" evaluations/s, "), std::string::npos) << result.err;
  EXPECT_EQ(result.out.rfind("Results:    " + archivePath(output_) + "\nBest robot: ", 0), 0u) << result.out;
  EXPECT_NE(result.out.find("\nDigest:     " + expected_digest_), std::string::npos) << result.out;
}

TEST_F(EvolveCommand, GoesOnAfterItWasInterrupted)
{
  for (const int signal : { SIGINT, SIGTERM })
  {
    ToolProcess tool(smallExperiment(output_));
    waitForProgress(output_, 5);
    tool.signal(signal);
    EXPECT_EQ(tool.finish(), 128 + signal);
    EXPECT_NE(tool.err().find("the same command goes on"), std::string::npos) << tool.err();
    EXPECT_LT(committedGenerations(output_), 82);
  }
  const ToolResult result = runTool(smallExperiment(output_));
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find(", resumed"), std::string::npos) << result.err;
  EXPECT_EQ(digestOf(output_), expected_digest_);
}

TEST_F(EvolveCommand, LosesNothingWhenKilled)
{
  int64_t committed = 0;
  for (int kills = 0; kills < 4; ++kills)
  {
    ToolProcess tool(smallExperiment(output_));
    waitForProgress(output_, 4);
    const int64_t seen = committedGenerations(output_);
    EXPECT_GE(seen, committed);
    tool.signal(SIGKILL);
    EXPECT_EQ(tool.finish(), 1000 + SIGKILL);
    committed = committedGenerations(output_);
    EXPECT_GE(committed, seen);
  }
  EXPECT_LT(committed, 82);
  EXPECT_EQ(runTool(smallExperiment(output_)).status, 0);
  EXPECT_EQ(digestOf(output_), expected_digest_);
}

TEST_F(EvolveCommand, GrowsAFinishedExperiment)
{
  EXPECT_EQ(runTool(smallExperiment(output_, { "--config", folder_.file("short.yaml") })).status, 2);
  Words shorter = smallExperiment(output_);
  shorter[10] = "10";  // generations
  shorter[12] = "1";   // trials
  EXPECT_EQ(runTool(shorter).status, 0);
  EXPECT_NE(digestOf(output_), expected_digest_);
  EXPECT_EQ(runTool(smallExperiment(output_)).status, 0);
  EXPECT_EQ(digestOf(output_), expected_digest_);
}

TEST_F(EvolveCommand, DiffersWithTheSeed)
{
  Words other = smallExperiment(output_);
  other.back() = "4";
  EXPECT_EQ(runTool(other).status, 0);
  EXPECT_NE(digestOf(output_), expected_digest_);
}

TEST_F(EvolveCommand, RefusesAnotherExperimentInTheSameFolder)
{
  Words words = smallExperiment(output_);
  words[10] = "0";
  EXPECT_EQ(runTool(words).status, 0);
  words.back() = "4";
  const ToolResult result = runTool(words);
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("seed"), std::string::npos) << result.err;
}

TEST_F(EvolveCommand, TakesParametersFromAFile)
{
  std::ofstream(folder_.file("small.yaml")) << "output: " << output_ << "\ngrid: [2, 2, 2]\nlifetime: 0.02\n"
                                            << "population: 6\ngenerations: 40\ntrials: 2\nseed: 3\nsimulators: 2\n";
  const ToolResult result = runTool({ "evolve", "--config", folder_.file("small.yaml") });
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(digestOf(output_), expected_digest_);
}

TEST_F(EvolveCommand, WritesToTheHomeFolderIfNoneIsNamed)
{
  const Words words = { "evolve",        "--grid", "2x2x2",           "--lifetime", "0.01",
                        "--generations", "0",      "--mutation_rate", "0.5" };
  const ToolResult result = runTool(words, "", { { "HOME", folder_.file("home") } });
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(std::filesystem::exists(folder_.file("home/devo_evo/evo_devo-paper-0.5-seed-1/experiment.db")));
}

TEST_F(EvolveCommand, TakesARelativeFolderFromWhereItIsCalled)
{
  const std::string here = std::filesystem::current_path();
  std::filesystem::current_path(folder_.file(""));
  Words words = smallExperiment("runs/./first/");
  words[10] = "0";
  const ToolResult result = runTool(words);
  std::filesystem::current_path(here);
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("/runs/first/experiment.db\n"), std::string::npos) << result.out;
}

TEST_F(EvolveCommand, FailsWhereItCannotWrite)
{
  const ToolResult result = runTool(smallExperiment("/proc/devo_evo"));
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("/proc/devo_evo"), std::string::npos) << result.err;
}

TEST(DigestCommand, FailsWhereThereIsNoExperiment)
{
  const TemporaryFolder folder;
  const ToolResult result = runTool({ "digest", folder.file("nothing") });
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err.rfind("devo_evo: error: ", 0), 0u) << result.err;
}
}  // namespace
}  // namespace devo_evo
