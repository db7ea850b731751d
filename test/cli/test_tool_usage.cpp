#include "cli/tool_process.h"

#include "devo_evo/experiment/parameters.h"

#include <gtest/gtest.h>

namespace devo_evo
{
namespace
{
TEST(Tool, TellsItsVersion)
{
  const ToolResult result = runTool({ "--version" });
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out.rfind("devo_evo ", 0), 0u) << result.out;
}

TEST(Tool, HelpsWithEveryCommand)
{
  EXPECT_NE(runTool({ "--help" }).out.find("evaluate"), std::string::npos);
  for (const std::string command : { "evaluate", "evolve", "digest", "study", "verify", "diff", "info", "export",
                                     "import", "explain", "manual", "parameters", "render", "overview", "gait_map" })
  {
    const ToolResult result = runTool({ command, "--help" });
    EXPECT_EQ(result.status, 0) << command;
    EXPECT_NE(result.out.find("Usage: devo_evo " + command), std::string::npos) << result.out;
    EXPECT_EQ(result.err, "");
  }
}

TEST(Tool, OffersEveryParameterOfAnExperimentAndOfAStudy)
{
  const std::string evolve = runTool({ "evolve", "--help" }).out, study = runTool({ "study", "--help" }).out;
  for (const ParameterSpec& spec : parameterSpecs())
  {
    const std::string option = "--" + spec.name + " ";
    const bool threads = spec.name == "simulators";
    EXPECT_EQ(evolve.find(threads ? "--threads" : option) != std::string::npos,
              spec.group != "nodes" && spec.group != "player" && spec.group != "study")
        << spec.name;
    EXPECT_EQ(study.find(threads ? "--threads" : option) != std::string::npos,
              spec.group != "nodes" && spec.group != "player")
        << spec.name;
  }
}

TEST(Tool, RefusesWrongUsageWithStatusTwo)
{
  const std::vector<std::vector<std::string>> wrong = {
    {},
    { "dance" },
    { "--nonsense" },
    { "evaluate" },
    { "digest" },
    { "evolve", "surplus" },
    { "evolve", "--gravity" },
    { "evolve", "--seed", "1", "--seed", "2" },
    { "evaluate", "--trials", "2", "-" },
    { "parameters", "--yaml", "--markdown" },
  };
  for (const auto& arguments : wrong)
  {
    const ToolResult result = runTool(arguments);
    EXPECT_EQ(result.status, 2) << ::testing::PrintToString(arguments);
    EXPECT_EQ(result.err.rfind("devo_evo: error: ", 0), 0u) << result.err;
    EXPECT_EQ(result.out, "");
  }
}

TEST(Tool, NamesTheCommandOrParameterProbablyMeant)
{
  EXPECT_EQ(runTool({ "dance" }).err,
            "devo_evo: error: there is no command \"dance\"; the commands are evaluate, evolve, digest, study, verify, "
            "diff, info, export, import, explain, manual, parameters, render, overview, gait_map, figures, report\n");
  EXPECT_EQ(runTool({ "evolve", "--lifetme", "3" }).err,
            "devo_evo: error: --lifetme: there is no parameter \"lifetme\"; the closest is lifetime\n");
}

TEST(Tool, RefusesValuesThatAreNotAllowed)
{
  const ToolResult option = runTool({ "evolve", "--lifetime", "nan" });
  EXPECT_EQ(option.status, 2);
  EXPECT_EQ(option.err,
            "devo_evo: error: --lifetime: lifetime is \"nan\"; it must be a number within 0.001 to 1000 s\n");

  const TemporaryFolder folder;
  const std::string config = folder.file("config.yaml");
  std::ofstream(config) << "trials: 2\npopulation: all\n";
  const ToolResult file = runTool({ "evolve", "--config", config });
  EXPECT_EQ(file.status, 2);
  EXPECT_EQ(file.err,
            "devo_evo: error: " + config + ":2: population is \"all\"; it must be a whole number within 2 to 10000\n");
}

TEST(Tool, PrintsParametersAsTextYamlAndMarkdown)
{
  EXPECT_EQ(runTool({ "parameters", "--yaml" }).out, parametersAsYaml());
  EXPECT_EQ(runTool({ "parameters", "--markdown" }).out, parametersAsMarkdown());
  const std::string text = runTool({ "parameters" }).out;
  for (const ParameterSpec& spec : parameterSpecs())
  {
    EXPECT_NE(text.find(spec.name + ": " + spec.default_text), std::string::npos) << spec.name;
  }
}
}  // namespace
}  // namespace devo_evo
