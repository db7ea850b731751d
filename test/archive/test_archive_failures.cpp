// What can go wrong with the file: each gets a clear ArchiveError, and nothing that was committed is lost.

#include "devo_evo/archive/archive.h"

#include "archive/output_folder.h"
#include "archive/test_tools.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <fstream>

namespace devo_evo::test
{
namespace
{
using testing::AssertionResult;

AssertionResult contains(const std::string& text, const std::string& part)
{
  return (text.find(part) != std::string::npos ? testing::AssertionSuccess() : testing::AssertionFailure())
         << "\"" << text << "\" should contain \"" << part << "\"";
}

std::string readFile(const std::string& path)
{
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

void writeFile(const std::string& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
}

class FailureTest : public testing::Test
{
protected:
  std::string failureToWrite()
  {
    return messageOf<ArchiveError>([&] { openArchiveForWriting(settings_, someProvenance()); });
  }
  std::string failureToRead()
  {
    return messageOf<ArchiveError>([&] { openArchiveForReading(settings_.output); });
  }
  std::string file() const { return archivePath(settings_.output); }

  TemporaryFolder folder_;
  ExperimentSettings settings_ = smallExperiment(folder_.path());
};

TEST_F(FailureTest, noArchiveToRead)
{
  EXPECT_TRUE(contains(failureToRead(), "there is no archive " + file()));
}

TEST_F(FailureTest, aFolderThatMustNotBeLookedInto)
{
  openArchiveForWriting(settings_, someProvenance());
  chmod(folder_.path().c_str(), 0000);
  EXPECT_TRUE(succeedsAsOrdinaryUser([&] { return contains(failureToRead(), "Permission denied"); }));
  chmod(folder_.path().c_str(), 0755);
}

TEST_F(FailureTest, aFileWhereTheFolderShouldBe)
{
  settings_.output += "/file";
  writeFile(settings_.output, "not a folder");
  EXPECT_TRUE(contains(failureToWrite(), settings_.output));
  EXPECT_EQ(readFile(settings_.output), "not a folder");
}

TEST_F(FailureTest, aFolderThatMustNotBeWritten)
{
  chmod(folder_.path().c_str(), 0555);
  EXPECT_TRUE(succeedsAsOrdinaryUser([&] { return contains(failureToWrite(), "cannot be written"); }));
  settings_.output += "/sub";
  EXPECT_TRUE(succeedsAsOrdinaryUser([&] { return contains(failureToWrite(), "cannot be made"); }));
  chmod(folder_.path().c_str(), 0755);
}

TEST_F(FailureTest, anArchiveThatMustNotBeWritten)
{
  openArchiveForWriting(settings_, someProvenance());
  chmod(folder_.path().c_str(), 0777);
  chmod((folder_.path() + "/experiment.lock").c_str(), 0666);
  chmod(file().c_str(), 0444);
  EXPECT_TRUE(succeedsAsOrdinaryUser([&] { return contains(failureToWrite(), "must not be written"); }));
}

TEST_F(FailureTest, somethingThatIsNotADatabase)
{
  const std::string text(5000, 'x');
  writeFile(file(), text);
  EXPECT_TRUE(contains(failureToWrite(), "not an SQLite database"));
  EXPECT_TRUE(contains(failureToRead(), "not an SQLite database"));
  EXPECT_EQ(readFile(file()), text);
}

TEST_F(FailureTest, aDatabaseOfSomebodyElse)
{
  openFile(settings_.output, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
      .exec("CREATE TABLE recipes (name TEXT); INSERT INTO recipes VALUES ('waffles');");
  const std::string before = readFile(file());
  EXPECT_TRUE(contains(failureToWrite(), "database of another program"));
  EXPECT_TRUE(contains(failureToRead(), "database of another program"));
  EXPECT_EQ(readFile(file()), before);
}

TEST_F(FailureTest, anArchiveOfANewerVersion)
{
  openArchiveForWriting(settings_, someProvenance());
  openFile(settings_.output, SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 99");
  EXPECT_TRUE(contains(failureToWrite(), "version 99"));
  EXPECT_TRUE(contains(failureToRead(), "version 99"));
}

TEST_F(FailureTest, aParameterOfANewerVersion)
{
  openArchiveForWriting(settings_, someProvenance());
  openFile(settings_.output, SQLite::OPEN_READWRITE)
      .exec("INSERT INTO parameters (name, value, unit) VALUES ('antigravity', '1', '')");
  EXPECT_TRUE(contains(failureToWrite(), "antigravity"));
  EXPECT_TRUE(contains(failureToRead(), "antigravity"));
}

TEST_F(FailureTest, anEmptyFileIsAnExperimentThatHasNotBegun)
{
  writeFile(file(), "");
  EXPECT_TRUE(contains(failureToRead(), "has not begun"));
  EXPECT_EQ(failureToWrite(), "");
}

TEST_F(FailureTest, aTruncatedFile)
{
  {
    const auto archive = openArchiveForWriting(settings_, someProvenance());
    evolve(*archive, settings_, 1, 20);
  }
  writeFile(file(), readFile(file()).substr(0, 3 * 4096));
  const std::string message = messageOf<ArchiveError>([&] { openArchiveForReading(settings_.output)->digest(); });
  EXPECT_TRUE(contains(message, "damaged"));
}

TEST_F(FailureTest, everyPageOverwrittenInTurn)
{
  {
    const auto archive = openArchiveForWriting(settings_, someProvenance());
    evolve(*archive, settings_, 1, 10);
  }
  const std::string intact = readFile(file());
  const std::string digest = openArchiveForReading(settings_.output)->digest();
  int noticed = 0;
  for (size_t page = 0; page < intact.size() / 4096; ++page)
  {
    std::string damaged = intact;
    damaged.replace(page * 4096, 512, std::string(512, '\x5a'));
    writeFile(file(), damaged);
    noticed += contains(messageOf<ArchiveError>(
                            [&]
                            {
                              const auto archive = openArchiveForReading(settings_.output);
                              archive->trialStates();
                              archive->readLineage(1, archive->championOf(1));
                              archive->findEvaluation(Hash128{});
                              EXPECT_EQ(archive->digest(), digest);
                            }),
                        file());
  }
  EXPECT_GT(noticed, 5);
}

TEST_F(FailureTest, aGenomeThatChangedIsNoticed)
{
  const auto archive = openArchiveForWriting(settings_, someProvenance());
  evolve(*archive, settings_, 1, 3);
  const std::string champion = std::to_string(archive->championOf(1));
  openFile(settings_.output, SQLite::OPEN_READWRITE)
      .exec("UPDATE genomes SET phase_initial = zeroblob(32) WHERE id = " + champion);
  EXPECT_TRUE(contains(messageOf<ArchiveError>([&] { archive->trialStates(); }), "1/" + champion));
  openFile(settings_.output, SQLite::OPEN_READWRITE)
      .exec("UPDATE genomes SET phase_initial = zeroblob(31) WHERE id = " + champion);
  EXPECT_TRUE(contains(messageOf<ArchiveError>([&] { archive->trialStates(); }), "31 bytes instead of 32"));
}

TEST_F(FailureTest, genomesThatDoNotFitTheSettingsAreNoticed)
{
  settings_.evolution.mutation_rate = 0.5;
  evolve(*openArchiveForWriting(settings_, someProvenance()), settings_, 1, 0);
  openFile(settings_.output, SQLite::OPEN_READWRITE)
      .exec("UPDATE parameters SET value = 'self_adaptive' WHERE name = 'mutation_rate'");
  EXPECT_TRUE(contains(messageOf<ArchiveError>([&] { openArchiveForReading(settings_.output)->trialStates(); }),
                       "mutation_rate has 0 values; self-adaptation needs one per voxel, 4"));
}

TEST_F(FailureTest, settingsThatContradictEachOtherAreNoticed)
{
  openArchiveForWriting(settings_, someProvenance());
  openFile(settings_.output, SQLite::OPEN_READWRITE)
      .exec("UPDATE parameters SET value = '64x64x64' WHERE name = 'grid'");
  EXPECT_TRUE(contains(failureToRead(), "grid is 64x64x64; it must have at most 32768 voxels"));
}

TEST_F(FailureTest, readingAFileWithoutEndEnds)
{
  openArchiveForWriting(settings_, someProvenance());
  openFile(settings_.output, SQLite::OPEN_READWRITE)
      .exec(
          "DROP VIEW champions; DROP TABLE generations; CREATE VIEW generations AS "
          "WITH RECURSIVE numbers(n) AS (SELECT 1 UNION ALL SELECT n + 1 FROM numbers) "
          "SELECT n AS trial, 0 AS generation, 0 AS champion FROM numbers");
  const auto archive = openArchiveForReading(settings_.output);
  EXPECT_TRUE(contains(messageOf<ArchiveError>([&] { archive->digest(); }), "more to read in it than its size allows"));
  EXPECT_TRUE(contains(messageOf<ArchiveError>([&] { archive->trials(); }), "more to read in it than its size allows"));
}

TEST_F(FailureTest, aValueLargerThanAnyOfOursIsNotRead)
{
  const auto archive = openArchiveForWriting(settings_, someProvenance());
  evolve(*archive, settings_, 1, 0);
  openFile(settings_.output, SQLite::OPEN_READWRITE).exec("UPDATE genomes SET phase_initial = zeroblob(20000000)");
  EXPECT_TRUE(contains(messageOf<ArchiveError>([&] { archive->trialStates(); }), "more to read in it than its size"));
}

TEST_F(FailureTest, nonsenseInTheTablesIsNoticed)
{
  const std::vector<std::string> changes = {
    "UPDATE individuals SET parent = id",
    "UPDATE individuals SET parent = id + 1",
    "UPDATE individuals SET age = 'old'",
    "UPDATE individuals SET age = 9223372036854775807",
    "UPDATE individuals SET age = generation + 1",
    "UPDATE individuals SET generation = generation + 100, age = 0",
    "UPDATE individuals SET fitness = NULL",
    "UPDATE individuals SET valid = 1 - valid",
    "UPDATE individuals SET fitness = 'far'",
    "UPDATE individuals SET genome_hash = 'sixteen letters!'",
    "UPDATE individuals SET phenotype_hash = x'00'",
    "UPDATE survivors SET id = 999999",
    "UPDATE survivors SET id = 'me'",
    "UPDATE generations SET generation = generation + 9223372036854775800",
    "UPDATE generations SET generation = generation + 1000",
    "UPDATE generations SET generation = -1 - generation",
    "UPDATE parameters SET value = '-3' WHERE name = 'population'",
    "UPDATE parameters SET value = '64x64x64' WHERE name = 'grid'",
    "DELETE FROM individuals",
    "DROP TABLE genomes",
    "DROP TABLE individuals; CREATE VIEW individuals AS SELECT 1 AS id",
  };
  for (const std::string& change : changes)
  {
    settings_.output = folder_.path() + "/" + std::to_string(&change - changes.data());
    {
      const auto archive = openArchiveForWriting(settings_, someProvenance());
      evolve(*archive, settings_, 1, 3);
    }
    bool applied = true;
    try
    {
      SQLite::Database database = openFile(settings_.output, SQLite::OPEN_READWRITE);
      database.exec("PRAGMA writable_schema = ON; " + change);
    }
    catch (const SQLite::Exception&)
    {
      applied = false;  // the table's own checks refuse it
    }
    const std::string message =
        messageOf<ArchiveError>([&] { openArchiveForReading(settings_.output)->trialStates(); });
    EXPECT_EQ(message.empty(), !applied) << change << ": " << message;
  }
}

TEST_F(FailureTest, aFullDiskKeepsWhatWasCommitted)
{
  // A page limit makes SQLite fail as a full disk does.
  constexpr int64_t FULL = 200 * 1024;
  GenerationRecord refused;
  std::string message;
  int64_t committed = -1;
  {
    const auto archive = openArchiveForWriting(settings_, someProvenance(), FULL);
    Trial trial(settings_.evolution, *makeBody(settings_.body), 1);
    while (message.empty())
    {
      evaluateAll(trial);
      refused = trial.select();
      message = messageOf<ArchiveError>([&] { archive->commitGeneration(refused); });
      committed += message.empty() ? 1 : 0;
      trial.breed();
    }
    EXPECT_TRUE(contains(message, "no space left"));
    EXPECT_EQ(archive->trialStates().at(1).generation, committed);
    EXPECT_FALSE(messageOf<ArchiveError>([&] { archive->commitGeneration(refused); }).empty());
  }
  EXPECT_GT(committed, 5);
  EXPECT_EQ(openFile(settings_.output).execAndGet("PRAGMA integrity_check").getString(), "ok");

  const auto archive = openArchiveForWriting(settings_, someProvenance());
  EXPECT_EQ(archive->trialStates().at(1).generation, committed);
  archive->commitGeneration(refused);
  evolve(*archive, settings_, 1, committed + 5);
  const std::string digest = archive->digest();
  settings_.output += "/undisturbed";
  const auto undisturbed = openArchiveForWriting(settings_, someProvenance());
  evolve(*undisturbed, settings_, 1, committed + 5);
  EXPECT_EQ(digest, undisturbed->digest());
}

TEST_F(FailureTest, aDiskThatIsFullFromTheStart)
{
  const std::string message =
      messageOf<ArchiveError>([&] { openArchiveForWriting(settings_, someProvenance(), 4096); });
  EXPECT_TRUE(contains(message, "no space left"));
  EXPECT_EQ(failureToWrite(), "");
}

TEST_F(FailureTest, aFileThatWasMovedWhileItWasWrittenTo)
{
  const auto archive = openArchiveForWriting(settings_, someProvenance());
  evolve(*archive, settings_, 1, 3);
  std::filesystem::rename(file(), file() + ".moved");
  EXPECT_TRUE(contains(messageOf<ArchiveError>([&] { evolve(*archive, settings_, 1, 4); }), "was moved"));
  std::filesystem::rename(file() + ".moved", file());
  evolve(*archive, settings_, 1, 4);
}

TEST_F(FailureTest, networkFileSystemsAreTold)
{
  EXPECT_EQ(networkFileSystem(folder_.path()), "");
  EXPECT_EQ(networkFileSystem(folder_.path() + "/not/there/yet"), "");

  const std::string mounts =
      "22 1 254:0 / / rw,relatime shared:1 - ext4 /dev/vda rw\n"
      "40 22 0:50 / /home/me/far\\040away rw - fuse.sshfs me@far:/ rw,user_id=0\n"
      "41 40 0:51 / /home/me/far\\040away/near rw - fuse.fuse-overlayfs overlay rw\n"
      "42 22 0:52 / /mnt/disk rw - fuseblk /dev/sdb1 rw\n";
  EXPECT_EQ(fuseNetworkFileSystem(mounts, "/home/me/far away/output"), "fuse.sshfs");
  EXPECT_EQ(fuseNetworkFileSystem(mounts, "/home/me/far away"), "fuse.sshfs");
  EXPECT_EQ(fuseNetworkFileSystem(mounts, "/home/me/far away/near/output"), "");
  EXPECT_EQ(fuseNetworkFileSystem(mounts, "/home/me/far away too"), "");
  EXPECT_EQ(fuseNetworkFileSystem(mounts, "/mnt/disk/output"), "");
  EXPECT_EQ(fuseNetworkFileSystem("nonsense", "/mnt/disk/output"), "");
}
}  // namespace
}  // namespace devo_evo::test
