#include "cli/short_lives.h"

#include "devo_evo/experiment/parameters.h"

#include <algorithm>

namespace devo_evo
{
namespace
{
using Json = nlohmann::json;

class InfoCommand : public ShortLives
{
protected:
  Json info() const
  {
    const ToolResult result = runTool({ "info", output_, "--json" });
    EXPECT_EQ(result.status, 0) << result.err;
    return Json::parse(result.out);
  }
};

TEST_F(InfoCommand, TellsParametersProvenanceProgressChampionsSizesAndDigest)
{
  const Json told = info();
  EXPECT_EQ(told.at("archive"), archivePath(output_));
  EXPECT_EQ(told.at("parameters").at("grid"), "2x2x1");
  EXPECT_EQ(told.at("parameters").at("founders"), "random");
  ASSERT_EQ(told.at("starts").size(), 1u);
  const Json& start = told.at("starts").at(0);
  EXPECT_EQ(runTool({ "--version" }).out, "devo_evo " + start.at("version").get<std::string>() + "\n");
  for (const char* field : { "start_utc", "stop_utc", "compiler", "processor", "instruction_set", "host" })
  {
    EXPECT_NE(start.at(field), "") << field;
  }
  EXPECT_EQ(start.at("generations_at_stop"), 12);
  EXPECT_EQ(start.at("engine_fingerprint").get<std::string>().size(), 16u);
  EXPECT_EQ(told.at("processors"), Json::array({ start.at("processor") }));
  ASSERT_EQ(told.at("trials").size(), 2u);
  const Json& trial = told.at("trials").at(1);
  EXPECT_EQ(trial.at("last_generation"), 5);
  EXPECT_EQ(trial.at("individuals"), 29);
  EXPECT_EQ(trial.at("fitness"),
            test::openFile(output_)
                .execAndGet("SELECT best_fitness FROM generations WHERE trial = 2 AND generation = 5")
                .getDouble());
  EXPECT_EQ(told.at("bytes").at("archive"), original.size());
  EXPECT_EQ(told.at("digest").get<std::string>() + "\n", runTool({ "digest", output_ }).out);
}

TEST_F(InfoCommand, TellsPeopleTheSame)
{
  const Json told = info();
  const ToolResult result = runTool({ "info", output_ });
  EXPECT_EQ(result.status, 0);
  for (const auto& [name, value] : told.at("parameters").items())
  {
    EXPECT_TRUE(contains(result.out, "\n    " + name + ": " + value.get<std::string>() + "\n"));
  }
  EXPECT_TRUE(contains(result.out, told.at("starts").at(0).at("processor").get<std::string>()));
  EXPECT_TRUE(contains(result.out, "when 12 generations were finished\n"));
  EXPECT_TRUE(contains(result.out, "\n    2: generation 5/5, 29 individuals; champion 2/"));
  EXPECT_TRUE(contains(result.out, "\nDigest: " + told.at("digest").get<std::string>() + "\n"));
}

TEST_F(InfoCommand, TellsOfEveryStartAndOfThoseThatWereKilled)
{
  edit(output_, "DELETE FROM stops");
  ASSERT_NO_FATAL_FAILURE(evolveShortLives(output_, { { "generations", "6" } }));
  const Json starts = info().at("starts");
  ASSERT_EQ(starts.size(), 2u);
  EXPECT_EQ(starts.at(0).at("stop_utc"), nullptr);
  EXPECT_EQ(starts.at(1).at("generations_at_stop"), 14);
  EXPECT_TRUE(contains(runTool({ "info", output_ }).out, "(no stop noted: it still runs, or was killed)"));
}

TEST_F(InfoCommand, TellsWhoseSimulatorsEvaluated)
{
  EXPECT_EQ(info().at("starts").at(0).at("evaluators"), Json::array());  // the tool itself
  edit(output_, "INSERT INTO evaluators VALUES (1, 'library', 'Difference Engine', 'scalar', '1.2.3', 17)");
  const Json told = info();
  EXPECT_EQ(told.at("starts").at(0).at("evaluators"), Json::array({ { { "host", "library" },
                                                                      { "processor", "Difference Engine" },
                                                                      { "instruction_set", "scalar" },
                                                                      { "version", "1.2.3" },
                                                                      { "evaluations", 17 } } }));
  EXPECT_EQ(told.at("processors").size(), 2u);
  EXPECT_TRUE(contains(runTool({ "info", output_ }).out,
                       "\n        simulators on host library: 17 robots; Difference Engine, scalar, devo_evo 1.2.3\n"));
}

TEST_F(InfoCommand, FailsWhereThereIsNoExperiment)
{
  const ToolResult result = runTool({ "info", folder_.file("nothing") });
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.out, "");
  EXPECT_TRUE(contains(result.err, "there is no archive " + folder_.file("nothing")));
}

TEST(ExplainCommand, TellsMeaningUnitAndFormulaFromWhereItStands)
{
  const ToolResult result = runTool({ "explain", "fitness" });
  EXPECT_EQ(result.status, 0);
  EXPECT_TRUE(contains(result.out, "fitness, measure (docs/measures.md)\n"));
  EXPECT_TRUE(contains(result.out, "\n    Unit: body lengths\n"));
  EXPECT_TRUE(contains(result.out, "\n    Formula: "));
  EXPECT_TRUE(contains(result.out, "fitness, field of RobotEvaluation (msg/RobotEvaluation.msg)\n"));
  const Json json = Json::parse(runTool({ "explain", "individuals.parent", "--json" }).out);
  ASSERT_EQ(json.size(), 1u);
  EXPECT_EQ(json.at(0).at("name"), "parent");
  EXPECT_EQ(json.at(0).at("facts").at("Meaning"), "id; NULL: random (a founder, or injected)");
}

TEST(ExplainCommand, ListsAllNamesEachOfWhichItExplains)
{
  const Json all = Json::parse(runTool({ "explain", "--json" }).out);
  const std::string names = "\n" + runTool({ "explain" }).out;
  EXPECT_GT(all.size(), 200u);
  for (const Json& each : all)
  {
    EXPECT_TRUE(contains(names, "\n" + each.at("name").get<std::string>() + "\n"));
    EXPECT_FALSE(each.at("facts").empty()) << each;
  }
  for (const ParameterSpec& spec : parameterSpecs())
  {
    EXPECT_TRUE(contains(names, "\n" + spec.name + "\n"));
  }
}

TEST(ExplainCommand, NamesTheMostSimilarOfWhatItDoesNotKnow)
{
  const ToolResult result = runTool({ "explain", "fitnes" });
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.err.rfind("devo_evo: error: there is nothing called \"fitnes\"; the most similar is fitness", 0), 0u)
      << result.err;
}

TEST(ManualCommand, PrintsAPageThatRoffUnderstandsAndACompletionThatBashDoes)
{
  const ToolResult page = runTool({ "manual" });
  EXPECT_EQ(page.status, 0);
  EXPECT_EQ(page.out.rfind(".TH DEVO_EVO 1 ", 0), 0u);
  for (const std::string section : { "NAME", "SYNOPSIS", "DESCRIPTION", "COMMANDS" })
  {
    EXPECT_TRUE(contains(page.out, "\n.SH " + section + "\n"));
  }
  const TemporaryFolder folder;
  const ToolResult completion = runTool({ "manual", "--bash" });
  EXPECT_EQ(completion.status, 0);
  std::ofstream(folder.file("completion")) << completion.out;
  EXPECT_EQ(std::system(("bash -n " + folder.file("completion")).c_str()), 0);
  EXPECT_TRUE(contains(completion.out, "complete -o default -F _devo_evo devo_evo"));
}
}  // namespace
}  // namespace devo_evo
