// devo_evo study as a program: real lives, real kills.
#include "cli/tool_process.h"
#include "study/study_tools.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

using namespace devo_evo;

namespace
{
/// A study of every experiment with little robots and short lives: a second or two.
std::vector<std::string> tinyStudy(const std::string& output, const std::vector<std::string>& more = {})
{
  std::vector<std::string> arguments = { "study", "--output", output };
  for (const auto& [name, value] : std::vector<std::pair<std::string, std::string>>{ { "grid", "2x2x2" },
                                                                                     { "lifetime", "0.1" },
                                                                                     { "population", "4" },
                                                                                     { "trials", "2" },
                                                                                     { "generations", "3" },
                                                                                     { "baseline_trials", "1" },
                                                                                     { "sweep_trials", "1" },
                                                                                     { "baseline_generations", "1" },
                                                                                     { "sweep_generations", "1" },
                                                                                     { "sweep_48ths", "48" },
                                                                                     { "rigid_trials", "1" },
                                                                                     { "rigid_generations", "1" },
                                                                                     { "rigid_lifetime", "0.5" },
                                                                                     { "walks", "1" },
                                                                                     { "walk_steps", "4" },
                                                                                     { "neutral_lineages", "2" },
                                                                                     { "impact_reproductions", "20" },
                                                                                     { "friction_factors", "0.5" },
                                                                                     { "gravity_factors", "2" },
                                                                                     { "amplitude_factors", "0.5" },
                                                                                     { "slopes", "0.1" } })
  {
    arguments.insert(arguments.end(), { "--" + name, value });
  }
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

void waitUntilSaid(const ToolProcess& process, const std::string& text)
{
  for (int i = 0; i < 3000 && process.err().find(text) == std::string::npos; ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

std::string digestsOf(const std::string& study)
{
  std::string digests;
  for (const std::string arm :
       { "main/evo", "main/evo_devo", "baselines/evo-neutral", "baselines/evo-random_search",
         "baselines/evo_devo-neutral", "baselines/evo_devo-random_search", "sweep/evo-48_48", "rigid/evo",
         "rigid/evo_devo", "sweep/evo_devo-48_48", "partial/evo_devo_body", "partial/evo_devo_control" })
  {
    digests += arm + " " + runTool({ "digest", study + "/" + arm }).out;
  }
  return digests;
}

const std::vector<std::string> EVERYTHING = { "--only",
                                              "main,removed,walks,lineages,traces,robustness,impact,baselines,sweep,"
                                              "partial,rigid" };
}  // namespace

TEST(StudyCommand, isTheSameOnAnyThreadsAndInstructionsHoweverOftenItIsKilled)
{
  const TemporaryFolder folder;
  const std::string undisturbed = folder.file("undisturbed"), killed = folder.file("killed");
  const ToolResult whole = runTool(tinyStudy(undisturbed, EVERYTHING));
  ASSERT_EQ(whole.status, 0) << whole.err;
  EXPECT_EQ(whole.out, "Study: " + undisturbed + "\n");
  EXPECT_NE(whole.err.find("evaluations/s, measured on this machine"), std::string::npos);

  std::vector<std::string> others = EVERYTHING;
  others.insert(others.end(), { "--threads", "1", "--instruction_set", "scalar" });
  for (const std::string moment : { "generation ", "removed: done", "robustness: done" })
  {
    ToolProcess process(tinyStudy(killed, others));
    waitUntilSaid(process, moment);
    process.signal(SIGKILL);
    process.finish();
  }
  const ToolResult resumed = runTool(tinyStudy(killed, others));
  ASSERT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_TRUE(test::contentOfStudy(undisturbed) == test::contentOfStudy(killed));
  EXPECT_EQ(digestsOf(undisturbed), digestsOf(killed));
  EXPECT_EQ(runTool({ "verify", killed + "/baselines/evo-neutral" }).status, 0);
  EXPECT_EQ(runTool({ "verify", killed + "/baselines/evo_devo-random_search" }).status, 0);
}

TEST(StudyCommand, endsInOrderWhenItIsInterrupted)
{
  const TemporaryFolder folder;
  ToolProcess process({ "study", "--output", folder.file("study"), "--only", "main", "--grid", "2x2x2", "--lifetime",
                        "0.1", "--generations", "1000000" });
  waitUntilSaid(process, "generation ");
  process.signal(SIGINT);
  EXPECT_EQ(process.finish(), 128 + SIGINT);
  EXPECT_NE(process.err().find("stopped by SIGINT; the same command goes on where it was"), std::string::npos);
}

TEST(StudyCommand, onlyEstimatesIfThatIsAsked)
{
  const TemporaryFolder folder;
  const ToolResult estimate = runTool({ "study", "--scale", "paper", "--estimate", "--output", folder.file("study") });
  EXPECT_EQ(estimate.status, 0);
  EXPECT_NE(estimate.out.find("main             18601800     18601800   "), std::string::npos) << estimate.out;
  EXPECT_NE(estimate.out.find("sweep           148814400    148814400   "), std::string::npos) << estimate.out;
  EXPECT_FALSE(std::filesystem::exists(folder.file("study")));
}

TEST(StudyCommand, refusesWhatMakesNoSense)
{
  const TemporaryFolder folder;
  const std::string output = folder.file("study");
  const auto complaint = [&](const std::string& option, const std::string& value)
  {
    const ToolResult result = runTool({ "study", "--output", output, option, value });
    EXPECT_EQ(result.status, 2) << option;
    return result.err;
  };
  EXPECT_EQ(complaint("--scale", "tiny"),
            "devo_evo: error: --scale: scale is \"tiny\"; it must be quick, overnight or paper\n");
  EXPECT_NE(complaint("--only", "walk").find("only is \"walk\"; it must be of main,partial,removed,walks,"),
            std::string::npos);
  EXPECT_NE(complaint("--treatment", "evo").find("a study chooses treatments and selection itself"), std::string::npos);
  EXPECT_NE(complaint("--founders", "robots.jsonl").find("the founders of a study are random"), std::string::npos);
  EXPECT_NE(complaint("--only", "traces").find("run the part main first"), std::string::npos);
}

TEST(StudyCommand, takesNumbersFromAFileAndTheOthersFromTheScale)
{
  const TemporaryFolder folder;
  std::ofstream(folder.file("study.yaml")) << "trials: 5\nsweep_48ths: [24]\n";
  const ToolResult estimate = runTool({ "study", "--config", folder.file("study.yaml"), "--generations", "7",
                                        "--estimate", "--output", folder.file("study") });
  // Two treatments of 5 trials of 10 + 7 * 11 robots; two of 2 trials of 10 + 10 * 11.
  EXPECT_NE(estimate.out.find("main                  870 "), std::string::npos) << estimate.out;
  EXPECT_NE(estimate.out.find("sweep                 480 "), std::string::npos) << estimate.out;
}
