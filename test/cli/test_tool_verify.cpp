#include "cli/short_lives.h"

#include "devo_evo/soft_body/text.h"

namespace devo_evo
{
namespace
{
using Json = nlohmann::json;

constexpr int SOUND = 0, NOT_CHECKED = 1, WRONG_USAGE = 2, NOT_SOUND = 3;
constexpr int BORN = 2 * (4 + 5 * (4 + 1));  // in both trials: founders; children and injected

class VerifyCommand : public ShortLives
{
protected:
  ToolResult verify(const std::vector<std::string>& options = {}) const
  {
    std::vector<std::string> words = { "verify", output_ };
    words.insert(words.end(), options.begin(), options.end());
    return runTool(words);
  }

  Json verifyAsJson(std::vector<std::string> options, int status) const
  {
    options.emplace_back("--json");
    const ToolResult result = verify(options);
    EXPECT_EQ(result.status, status) << result.err;
    return Json::parse(result.out);
  }

  /// Changes the archive, and expects it to be found out in words that begin like this.
  void expectOffence(const std::string& sql, const std::string& place_and_beginning,
                     const std::vector<std::string>& options = { "--sample", "0" })
  {
    restore(output_);
    edit(output_, sql);
    const ToolResult result = verify(options);
    EXPECT_EQ(result.status, NOT_SOUND) << sql << "\n" << result.err;
    EXPECT_TRUE(contains(result.out, "\nNOT SOUND: " + place_and_beginning)) << sql;
    EXPECT_FALSE(contains(result.out, "\nSound: ")) << sql;
  }
};

TEST_F(VerifyCommand, SaysWhatItCheckedAndHowLongItTook)
{
  const ToolResult result = verify();
  EXPECT_EQ(result.status, SOUND) << result.err;
  EXPECT_EQ(result.out.rfind("Archive:   " + archivePath(output_) + "\n", 0), 0u) << result.out;
  EXPECT_TRUE(contains(result.out, "\nBirths:    58 individuals in 12 generations of 2 trials: parents, ages, "));
  EXPECT_TRUE(contains(result.out, "\nSelection: survivors, champions and medians of 12 generations of 2 trials\n"));
  EXPECT_TRUE(contains(result.out, "\nLives:     58 simulated again (a sample of 100 individuals and the champions)"));
  EXPECT_TRUE(contains(result.out, "\nTime:      "));
  EXPECT_TRUE(contains(result.out, "\nSound:     "));
}

TEST_F(VerifyCommand, SimulatesASampleAllOrALineage)
{
  const Json all = verifyAsJson({ "--all" }, SOUND);
  EXPECT_EQ(all.at("sound"), true);
  EXPECT_EQ(all.at("complete"), true);
  EXPECT_EQ(all.at("offence"), nullptr);
  EXPECT_GT(all.at("seconds"), 0.0);
  EXPECT_EQ(all.at("checked").at("individuals"), BORN);
  EXPECT_EQ(all.at("checked").at("simulated"), BORN);

  const int sampled = verifyAsJson({ "--sample", "9" }, SOUND).at("checked").at("simulated");
  EXPECT_GE(sampled, 9);
  EXPECT_LE(sampled, 9 + 2);  // the champions

  const Json lineage = verifyAsJson({ "--lineage", "2", "--threads", "1" }, SOUND);
  EXPECT_EQ(lineage.at("scope"), "the lineage of the champion of trial 2");
  const ToolResult ancestors = runTool({ "export", output_, "--lineage", "2", "--format", "json" });
  EXPECT_EQ(lineage.at("checked").at("simulated"), std::count(ancestors.out.begin(), ancestors.out.end(), '\n'));
}

TEST_F(VerifyCommand, NamesTheFirstOffenderOfAnEditedArchive)
{
  expectOffence("UPDATE individuals SET fitness = fitness + 1e-12 WHERE trial = 2 AND id IN (11, 7)",
                "2/7: fitness is ");
  expectOffence("UPDATE individuals SET parent = 1 - (parent = 1) WHERE trial = 1 AND id = 4", "1/4: parent is ");
  expectOffence("UPDATE individuals SET parent = 2000 WHERE trial = 1 AND id = 4", "1/4: its parent was born after it");
  expectOffence("UPDATE individuals SET age = age + 1 WHERE trial = 1 AND id = 8", "1/8: age is ");
  expectOffence("DELETE FROM survivors WHERE trial = 1 AND generation = 2 AND rank = 4",
                "trial 1, generation 2: the survivors do not follow from the selection rule");
  expectOffence("UPDATE generations SET champion = champion + 1 WHERE trial = 1 AND generation = 3",
                "trial 1, generation 3: champion is ");
  expectOffence("UPDATE individuals SET genome_hash = zeroblob(16) WHERE trial = 2 AND id = 0",
                "2/0: genome_hash is 0000");
  expectOffence("UPDATE parameters SET value = '4' WHERE name = 'seed'", "1/0: genome_hash is ");
}

TEST_F(VerifyCommand, NamesTheRowThatIsMissingWhateverItsTable)
{
  expectOffence("DELETE FROM individuals WHERE trial = 1 AND id = 6", "1/6: this individual is missing");
  const std::string champion = toText(numberIn(
      output_, "SELECT id FROM champions WHERE trial = 2 AND generation = (SELECT max(generation) FROM generations)"));
  expectOffence("DELETE FROM individuals WHERE trial = 2 AND id = " + champion,
                "2/" + champion + ": there is a genome, but this individual's row is missing in the table individuals");
  expectOffence("DELETE FROM genomes WHERE trial = 2 AND id = " + champion,
                "2/" + champion + ": it lives or has living descendants, but its row is missing in the table genomes");
  const std::string generation = "this generation's row is missing in the table generations";
  expectOffence("DELETE FROM generations WHERE trial = 2 AND generation = 1",
                "trial 2, generation 1: there are survivors, but " + generation);
  expectOffence("DELETE FROM generations WHERE trial = 2 AND generation = 5",
                "trial 2, generation 5: there are survivors, but " + generation);
  expectOffence("DELETE FROM generations WHERE trial = 2",
                "trial 2, generation 0: the trial has individuals, but no row in the table generations");
  expectOffence("UPDATE starts SET number = number + 1", "archive: rows are missing in the table starts");
}

TEST_F(VerifyCommand, FindsAnotherLifeBySimulatingIt)
{
  const std::vector<std::string> all = { "--all" };
  const std::string unique =
      toText(numberIn(output_,
                      "SELECT min(id) FROM individuals WHERE trial = 1 AND (SELECT count(*) FROM individuals AS i "
                      "WHERE i.phenotype_hash = individuals.phenotype_hash) = 1"));
  expectOffence("UPDATE individuals SET state_hash = x'0123456789abcdef' WHERE trial = 1 AND id = " + unique,
                "1/" + unique + ": state_hash is 0123456789abcdef in the archive, but ", all);
  expectOffence("UPDATE individuals SET turns = turns + 1e-12 WHERE trial = 2", "2/0: turns is ", all);
  expectOffence("UPDATE parameters SET value = '9.8' WHERE name = 'gravity'", "1/0: ", all);
}

TEST_F(VerifyCommand, FindsAnOffenceAgainstAnAncestorWhereverItsLineageIsAskedFor)
{
  const int64_t ancestor =
      numberIn(output_,
               "SELECT parent FROM individuals JOIN champions USING (trial, id) WHERE trial = 1 AND "
               "individuals.parent IS NOT NULL ORDER BY champions.generation DESC LIMIT 1");
  expectOffence("UPDATE individuals SET airborne_fraction = 0.5 WHERE trial = 1 AND id = " + toText(ancestor),
                "1/" + toText(ancestor) + ": airborne_fraction is 0.5 in the archive, but ", { "--lineage", "1" });
}

TEST_F(VerifyCommand, FindsAFlippedBitOfAGenome)
{
  const std::string unique =
      " FROM genomes WHERE trial = 2 AND (SELECT count(*) FROM genomes AS g WHERE g.phase_initial = "
      "genomes.phase_initial) = 1 ORDER BY id LIMIT 1";
  const int64_t id = numberIn(output_, "SELECT id" + unique);
  const std::string phases = textIn(output_, "SELECT phase_initial" + unique);
  std::string flipped = original;
  ASSERT_NE(flipped.find(phases), std::string::npos);
  // Also in what SQLite has deleted, and does not read.
  for (size_t place = flipped.find(phases); place != std::string::npos; place = flipped.find(phases))
  {
    flipped[place] = static_cast<char>(flipped[place] ^ 1);  // the last bit of the first phase
  }
  std::ofstream(archivePath(output_), std::ios::binary | std::ios::trunc) << flipped;
  const ToolResult result = verify({ "--sample", "0" });
  EXPECT_EQ(result.status, NOT_SOUND);
  EXPECT_TRUE(contains(result.out, "NOT SOUND: 2/" + toText(id) + ": the stored genome is not the one"));
}

TEST_F(VerifyCommand, FindsDamagedFilesUnsound)
{
  const auto expectUnsound = [this](const std::string& bytes)
  {
    std::ofstream(archivePath(output_), std::ios::binary | std::ios::trunc) << bytes;
    const Json found = verifyAsJson({}, NOT_SOUND);
    EXPECT_EQ(found.at("sound"), false);
    EXPECT_EQ(found.at("offence").at("place"), "archive");
    EXPECT_NE(found.at("offence").at("what"), "");
  };
  expectUnsound(original.substr(0, original.size() / 2));
  expectUnsound("no archive at all");
  expectUnsound("");
  std::string page = original;
  page.replace(4096, 100, 100, '\xff');  // the head of a table
  expectUnsound(page);
}

TEST_F(VerifyCommand, NamesTheOffenceInJson)
{
  const int64_t id = numberIn(output_,
                              "SELECT min(id) FROM individuals WHERE trial = 2 AND generation = 2 AND id NOT IN "
                              "(SELECT id FROM genomes WHERE trial = 2)");
  edit(output_, "DELETE FROM individuals WHERE trial = 2 AND id = " + toText(id));
  const Json offence = verifyAsJson({}, NOT_SOUND).at("offence");
  EXPECT_EQ(offence.at("place"), "2/" + toText(id));
  EXPECT_EQ(offence.at("trial"), 2);
  EXPECT_EQ(offence.at("generation"), 2);
  EXPECT_EQ(offence.at("id"), id);
  EXPECT_EQ(offence.at("what"), "this individual is missing; it was born in generation 2");
}

TEST_F(VerifyCommand, DoesNotSimulateTheArchiveOfAnotherEngine)
{
  edit(output_, "UPDATE starts SET engine_fingerprint = x'0123456789abcdef', version = '9.9.9'");
  const ToolResult result = verify();
  EXPECT_EQ(result.status, NOT_SOUND);
  EXPECT_TRUE(contains(result.out, "start 1 was made by devo_evo 9.9.9 with engine fingerprint 0123456789abcdef"));
}

TEST_F(VerifyCommand, EndsOnASignal)
{
  edit(output_, "UPDATE parameters SET value = '1000' WHERE name = 'lifetime'");  // which takes minutes
  ToolProcess tool({ "verify", output_, "--all" });
  tool.waitUntilCaught(SIGINT);
  tool.signal(SIGINT);
  EXPECT_EQ(tool.finish(), 128 + SIGINT);
  EXPECT_TRUE(contains(tool.err(), "stopped by SIGINT; nothing wrong was found so far"));
  EXPECT_FALSE(contains(tool.out(), "Sound: "));
}

TEST_F(VerifyCommand, FailsWhereThereIsNothingToCheck)
{
  const ToolResult nothing = runTool({ "verify", folder_.file("nothing") });
  EXPECT_EQ(nothing.status, NOT_CHECKED);
  EXPECT_EQ(nothing.out, "");
  EXPECT_TRUE(contains(nothing.err, "there is no archive " + folder_.file("nothing")));

  const ToolResult trial = verify({ "--lineage", "3" });
  EXPECT_EQ(trial.status, WRONG_USAGE);
  EXPECT_TRUE(contains(trial.err, "trial 3"));
}

TEST_F(VerifyCommand, RefusesContradictoryOptions)
{
  const std::vector<std::vector<std::string>> wrong = {
    { "--all", "--sample", "3" }, { "--all", "--lineage", "1" }, { "--lineage", "1", "--sample", "3" },
    { "--sample", "-1" },         { "--sample", "many" },        { "--lineage", "0" }
  };
  for (const auto& options : wrong)
  {
    EXPECT_EQ(verify(options).status, WRONG_USAGE) << ::testing::PrintToString(options);
  }
}
}  // namespace
}  // namespace devo_evo
