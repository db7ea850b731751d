#include "devo_evo/verification/verify.h"

#include "verification/real_experiment.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace devo_evo::test
{
namespace
{
std::string bytesOf(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

void writeBytes(const std::string& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

/// Everything that evolution decided, as text; whatever cannot be read is part of it.
std::string contentOf(const std::string& output)
{
  std::string content;
  try
  {
    SQLite::Database file = openFile(output);
    for (const char* table : { "parameters", "individuals", "genomes", "generations", "survivors", "founders" })
    {
      SQLite::Statement rows(file, std::string("SELECT * FROM ") + table);
      while (rows.executeStep())
      {
        for (int i = 0; i < rows.getColumnCount(); ++i)
        {
          const SQLite::Column column = rows.getColumn(i);
          content += std::to_string(column.getType()) + ":" + column.getString() + "|";
        }
      }
    }
  }
  catch (const std::exception& error)
  {
    content += error.what();
  }
  return content;
}

class VerifyTest : public testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    const TemporaryFolder folder;
    evolveReally(shortLives(folder.path()));
    original = bytesOf(archivePath(folder.path()));
  }

  VerifyTest() { restore(); }

  void restore() { writeBytes(archivePath(folder_.path()), original); }

  void edit(const std::string& sql)
  {
    restore();
    openFile(folder_.path(), SQLite::OPEN_READWRITE).exec(sql);
  }

  Verification verifyArchive(const VerificationScope& scope) const
  {
    const auto archive = openArchiveForReading(folder_.path());
    const auto farm = makeLocalFarm(makeBody(archive->settings().body), 1);
    return verify(*archive, scope, *farm, [](const Verification&) { return true; });
  }

  /// "1/7: fitness is ..." for the first offence; "" if there is none.
  std::string offence(const VerificationScope& scope) const
  {
    try
    {
      const Verification found = verifyArchive(scope);
      return found.offence ? found.offence->place() + ": " + found.offence->what : "";
    }
    catch (const ArchiveError& error)
    {
      return error.what();
    }
  }

  std::string offenceWithoutLives() const
  {
    VerificationScope scope;
    scope.sample = 0;
    return offence(scope);
  }

  std::string offenceWithAllLives() const
  {
    VerificationScope scope;
    scope.all = true;
    return offence(scope);
  }

  static std::string original;
  TemporaryFolder folder_;
};

std::string VerifyTest::original;

testing::AssertionResult startsWith(const std::string& text, const std::string& beginning)
{
  return text.rfind(beginning, 0) == 0 ? testing::AssertionSuccess() : testing::AssertionFailure() << text;
}

TEST_F(VerifyTest, findsASoundArchiveSoundAndSaysWhatItChecked)
{
  VerificationScope scope;
  scope.all = true;
  const Verification found = verifyArchive(scope);
  EXPECT_FALSE(found.offence) << found.offence->what;
  EXPECT_EQ(found.trials, 2);
  EXPECT_EQ(found.generations, 12);                     // generations 0 to 5 of both
  EXPECT_EQ(found.individuals, 2 * (4 + 5 * (4 + 1)));  // founders; children and injected
  EXPECT_EQ(found.simulated, found.individuals);
  EXPECT_EQ(found.genomes, countRows(folder_.path(), "genomes"));
}

TEST_F(VerifyTest, simulatesASampleOrALineageOnly)
{
  VerificationScope sample;
  sample.sample = 7;
  const int64_t simulated = verifyArchive(sample).simulated;
  EXPECT_GE(simulated, 7);
  EXPECT_LE(simulated, 9);  // and the two champions

  VerificationScope lineage;
  lineage.lineage_of = 2;
  const auto archive = openArchiveForReading(folder_.path());
  const auto ancestors = archive->readLineage(2, archive->championOf(2));
  EXPECT_EQ(verifyArchive(lineage).simulated, static_cast<int64_t>(ancestors.size()));
}

TEST_F(VerifyTest, stopsWhenItIsTold)
{
  const auto archive = openArchiveForReading(folder_.path());
  const auto farm = makeLocalFarm(makeBody(archive->settings().body), 1);
  const Verification found =
      verify(*archive, VerificationScope(), *farm, [](const Verification& so_far) { return so_far.generations < 3; });
  EXPECT_FALSE(found.complete);
  EXPECT_EQ(found.generations, 3);
}

TEST_F(VerifyTest, catchesAnEditedFitnessAndNamesTheRobot)
{
  edit("UPDATE individuals SET fitness = fitness + 1e-9 WHERE trial = 1 AND id = 7");
  EXPECT_TRUE(startsWith(offenceWithoutLives(), "1/7: fitness is "));
}

TEST_F(VerifyTest, catchesAnEditedFitnessThatFitsTheDisplacementBySimulating)
{
  edit("UPDATE individuals SET displacement_y_voxels = 2, fitness = 1 WHERE trial = 2 AND id = 9");
  EXPECT_TRUE(startsWith(offenceWithAllLives(), "2/9: "));
  EXPECT_TRUE(
      startsWith(offenceWithoutLives(), "2/9: "));  // it would have survived, so all of that generation are asked
}

TEST_F(VerifyTest, catchesEveryOtherEditedMeasureBySimulating)
{
  for (const std::string column : { "displacement_xy_voxels", "turns", "airborne_fraction" })
  {
    edit("UPDATE individuals SET " + column + " = " + column + " + 1e-12 WHERE trial = 1 AND id = 11");
    EXPECT_TRUE(startsWith(offenceWithAllLives(), "1/11: " + column + " is "));
  }
  edit("UPDATE individuals SET state_hash = x'0123456789abcdef' WHERE trial = 1 AND id = 11");
  EXPECT_TRUE(startsWith(offenceWithAllLives(), "1/11: state_hash is 0123456789abcdef in the archive, but "));
}

TEST_F(VerifyTest, catchesAnEditedParentAgeOrHash)
{
  edit("UPDATE individuals SET parent = CASE WHEN parent = 1 THEN 2 ELSE 1 END WHERE trial = 1 AND id = 5");
  EXPECT_NE(offenceWithoutLives().find("1/5: "), std::string::npos) << offenceWithoutLives();
  edit("UPDATE individuals SET age = age - 1 WHERE trial = 2 AND id = 5");
  EXPECT_NE(offenceWithoutLives().find("2/5: "), std::string::npos) << offenceWithoutLives();
  edit("UPDATE individuals SET genome_hash = zeroblob(16) WHERE trial = 2 AND id = 0");
  EXPECT_NE(offenceWithoutLives().find("2/0: "), std::string::npos) << offenceWithoutLives();
}

TEST_F(VerifyTest, catchesAnEditedGenome)
{
  const int64_t id = openFile(folder_.path()).execAndGet("SELECT min(id) FROM genomes WHERE trial = 1").getInt64();
  edit(
      "UPDATE genomes SET phase_initial = (SELECT phase_initial FROM genomes WHERE trial = 2 LIMIT 1) WHERE trial = 1 "
      "AND id = " +
      std::to_string(id));
  EXPECT_TRUE(startsWith(offenceWithoutLives(), "1/" + std::to_string(id) + ": the stored genome is not the one"));
}

TEST_F(VerifyTest, catchesMissingRows)
{
  for (const std::string row :
       { "individuals WHERE trial = 1 AND id = 5",
         "individuals WHERE trial = 2 AND id = (SELECT max(id) FROM individuals WHERE trial = 2)",
         "survivors WHERE trial = 1 AND generation = 3 AND rank = 2", "generations WHERE trial = 1 AND generation = 2",
         "generations WHERE trial = 2",
         "genomes WHERE trial = 2 AND id = (SELECT max(id) FROM genomes WHERE trial = 2)" })
  {
    edit("DELETE FROM " + row);
    EXPECT_NE(offenceWithoutLives(), "") << row;
  }
}

TEST_F(VerifyTest, catchesAnotherSeedOperatorOrPhysics)
{
  edit("UPDATE parameters SET value = '2' WHERE name = 'seed'");
  EXPECT_TRUE(startsWith(offenceWithoutLives(), "1/0: genome_hash is "));
  edit("UPDATE parameters SET value = '0.5' WHERE name = 'size_mutation_sigma'");
  EXPECT_NE(offenceWithoutLives(), "");
  edit("UPDATE parameters SET value = '9.8' WHERE name = 'gravity'");
  EXPECT_TRUE(startsWith(offenceWithAllLives(), "1/0: "));
}

/// The promise: a flipped byte is found if it changes anything of the evolution that the archive tells.
TEST_F(VerifyTest, catchesEveryFlippedByteThatChangesWhatIsTold)
{
  const std::string told = contentOf(folder_.path());
  int caught = 0;
  for (size_t place = 24; place < original.size(); place += 1499)
  {
    std::string flipped = original;
    flipped[place] = static_cast<char>(flipped[place] ^ 0x10);
    writeBytes(archivePath(folder_.path()), flipped);
    const bool found = !offenceWithAllLives().empty();
    caught += found ? 1 : 0;
    EXPECT_TRUE(found || contentOf(folder_.path()) == told) << "byte " << place << " is another, and nothing was found";
  }
  EXPECT_GT(caught, 10);
}

TEST_F(VerifyTest, takesGivenFoundersForSoundAndRefusesToResumeWithOthers)
{
  const TemporaryFolder folder;
  ExperimentSettings settings = shortLives(folder.path());
  const auto archive = openArchiveForReading(folder_.path());
  const Genome champion = archive->readIndividual(1, archive->championOf(1)).individual.genome;
  settings.evolution.founders = std::make_shared<std::vector<Genome>>(1, champion);
  evolveReally(settings);
  const auto reopened = openArchiveForReading(folder.path());
  EXPECT_EQ(reopened->readIndividual(2, 0).individual.genome, champion);
  EXPECT_FALSE(reopened->readIndividual(2, 1).individual.genome == champion);
  VerificationScope all;
  all.all = true;
  const auto farm = makeLocalFarm(makeBody(settings.body), 1);
  EXPECT_FALSE(verify(*reopened, all, *farm, [](const Verification&) { return true; }).offence);

  settings.evolution.founders.reset();
  const std::string refusal = messageOf<ArchiveError>([&] { openArchiveForWriting(settings, someProvenance()); });
  EXPECT_NE(refusal.find("founders are 1 given robots there and random here"), std::string::npos) << refusal;
}
}  // namespace
}  // namespace devo_evo::test
