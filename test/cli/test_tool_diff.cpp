#include "cli/short_lives.h"

namespace devo_evo
{
namespace
{
using Json = nlohmann::json;

constexpr int EQUAL = 0, NOT_COMPARED = 1, WRONG_USAGE = 2, DIFFERENT = 3;

class DiffCommand : public ShortLives
{
protected:
  DiffCommand() { restore(other_); }

  ToolResult diff() const { return runTool({ "diff", output_, other_ }); }

  Json diffAsJson(int status) const
  {
    const ToolResult result = runTool({ "diff", output_, other_, "--json" });
    EXPECT_EQ(result.status, status) << result.err;
    return Json::parse(result.out);
  }

  const std::string other_ = folder_.file("other");
};

TEST_F(DiffCommand, FindsEqualExperimentsEqualWhateverMadeThem)
{
  EXPECT_EQ(diff().status, EQUAL);
  EXPECT_EQ(diff().out, "12 generations are the same in both; they are equal\n");
  edit(other_, "UPDATE starts SET processor = 'Difference Engine'");
  const ToolResult result = diff();
  EXPECT_EQ(result.status, EQUAL);
  EXPECT_EQ(result.out.rfind("Provenance differs (which decides nothing):\n    processor: ", 0), 0u) << result.out;
  EXPECT_TRUE(contains(result.out, " in A, Difference Engine in B\n"));
  EXPECT_EQ(diffAsJson(EQUAL).at("equal"), true);
}

TEST_F(DiffCommand, NamesParametersFirst)
{
  std::filesystem::remove_all(other_);
  ASSERT_NO_FATAL_FAILURE(evolveShortLives(other_, { { "seed", "4" }, { "gravity", "9.5" }, { "generations", "2" } }));
  const ToolResult result = diff();
  EXPECT_EQ(result.status, DIFFERENT);
  EXPECT_EQ(result.out.rfind("Parameters differ:\n", 0), 0u) << result.out;
  EXPECT_TRUE(contains(result.out, "\n    gravity: 9.81 in A, 9.5 in B\n"));
  EXPECT_TRUE(contains(result.out, "\n    seed: 3 in A, 4 in B\n"));
  EXPECT_TRUE(contains(result.out, "\nTrial 1 parts in generation 0, with individual 1/0:\n"));
  EXPECT_TRUE(contains(result.out, "\nTrial 2 has 6 generations in A, 3 in B\n"));
  EXPECT_TRUE(contains(result.out, "\n0 generations are the same in both\n"));

  const Json json = diffAsJson(DIFFERENT);
  EXPECT_EQ(json.at("equal"), false);
  EXPECT_EQ(json.at("extents").at(1), Json({ { "trial", 2 }, { "generations_a", 6 }, { "generations_b", 3 } }));
}

TEST_F(DiffCommand, NamesTheFirstGenerationAndIndividualThatDifferAndHow)
{
  edit(other_, "UPDATE individuals SET turns = 0.125 WHERE trial = 2 AND id >= 16");
  edit(other_, "UPDATE individuals SET state_hash = x'0123456789abcdef' WHERE trial = 2 AND id = 12");
  const Json json = diffAsJson(DIFFERENT);
  EXPECT_EQ(json.at("parameters"), Json::array());
  EXPECT_EQ(json.at("equal_generations"), 6 + 2);  // all of trial 1, and two of trial 2
  ASSERT_EQ(json.at("trials").size(), 1u);
  const Json& trial = json.at("trials").at(0);
  EXPECT_EQ(trial.at("trial"), 2);
  EXPECT_EQ(trial.at("generation"), 2);
  EXPECT_EQ(trial.at("id"), 12);
  EXPECT_EQ(trial.at("differences").at(0).at("field"), "state_hash");
  EXPECT_EQ(trial.at("differences").at(0).at("b"), "0123456789abcdef");
  EXPECT_TRUE(contains(diff().out, "Trial 2 parts in generation 2, with individual 2/12:\n    state_hash: "));
}

TEST_F(DiffCommand, NamesSurvivorsThatDiffer)
{
  edit(other_, "UPDATE survivors SET id = id + 100 WHERE trial = 1 AND generation = 4 AND rank = 3");
  const ToolResult result = diff();
  EXPECT_EQ(result.status, DIFFERENT);
  EXPECT_TRUE(contains(result.out, "Trial 1 parts in generation 4, in its selection:\n    survivor of rank 3: "));
  EXPECT_EQ(diffAsJson(DIFFERENT).at("trials").at(0).at("id"), nullptr);
}

TEST_F(DiffCommand, NamesFoundersThatDiffer)
{
  const std::string founders = folder_.file("founders.jsonl");
  ASSERT_EQ(runTool({ "export", output_, "--individual", "1/0", "--out", founders }).status, 0);
  std::filesystem::remove_all(other_);
  ASSERT_NO_FATAL_FAILURE(evolveShortLives(other_, { { "founders", founders } }));
  const ToolResult result = diff();
  EXPECT_EQ(result.status, DIFFERENT);
  EXPECT_EQ(result.out.rfind("Parameters differ:\n    founders: random in A, ", 0), 0u) << result.out;
  // Individual 1/0 is the founder itself; 2/0 was another one.
  EXPECT_FALSE(contains(result.out, "individual 1/0:"));
  EXPECT_TRUE(contains(result.out, "Trial 2 parts in generation 0, with individual 2/0:\n"));
}

TEST_F(DiffCommand, FailsWhereOneOfThemCannotBeRead)
{
  const ToolResult missing = runTool({ "diff", output_, folder_.file("nothing") });
  EXPECT_EQ(missing.status, NOT_COMPARED);
  EXPECT_EQ(missing.out, "");
  EXPECT_TRUE(contains(missing.err, "there is no archive " + folder_.file("nothing")));
  std::ofstream(archivePath(other_), std::ios::binary | std::ios::trunc) << original.substr(0, 9000);
  EXPECT_EQ(diff().status, NOT_COMPARED);
  EXPECT_TRUE(contains(diff().err, archivePath(other_)));
  EXPECT_EQ(runTool({ "diff", output_ }).status, WRONG_USAGE);
}
}  // namespace
}  // namespace devo_evo
