// kill -9 at any instant loses nothing that was committed; many read while one writes.

#include "devo_evo/archive/archive.h"

#include "archive/schema.h"
#include "archive/test_tools.h"

#include <gtest/gtest.h>

#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <chrono>
#include <set>
#include <thread>

namespace devo_evo::test
{
namespace
{
constexpr int64_t TRIAL = 1;

/// A process that commits generation after generation, and tells of each.
class WriterProcess
{
public:
  explicit WriterProcess(const ExperimentSettings& settings)
  {
    int ends[2];
    if (pipe(ends) != 0)
    {
      throw std::runtime_error("no pipe");
    }
    process_ = fork();
    if (process_ == 0)
    {
      close(ends[0]);
      const auto archive = openArchiveForWriting(settings, someProvenance());
      evolve(*archive, settings, TRIAL, 1000000,
             [&](const GenerationRecord& record, const Trial&)
             {
               if (write(ends[1], &record.generation, sizeof(record.generation)) < 0)
               {
                 _exit(1);
               }
             });
      _exit(0);
    }
    close(ends[1]);
    news_ = ends[0];
  }

  ~WriterProcess()
  {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
    close(news_);
  }

  WriterProcess(const WriterProcess&) = delete;
  WriterProcess& operator=(const WriterProcess&) = delete;

  /// Waits for a generation to be committed. @return its number; -1 if the process is dead.
  int64_t nextCommit()
  {
    int64_t generation;
    return read(news_, &generation, sizeof(generation)) == sizeof(generation) ? generation : -1;
  }

  /// @return the last generation of which the process told.
  int64_t killAfter(int commits, std::chrono::microseconds delay)
  {
    int64_t last = -1;
    for (int i = 0; i < commits; ++i)
    {
      last = nextCommit();
    }
    std::this_thread::sleep_for(delay);
    kill(process_, SIGKILL);
    for (int64_t generation = nextCommit(); generation >= 0; generation = nextCommit())
    {
      last = generation;
    }
    return last;
  }

private:
  pid_t process_;
  int news_;
};

class CrashTest : public testing::Test
{
protected:
  std::string integrity() const
  {
    return openFile(settings_.output, SQLite::OPEN_READWRITE).execAndGet("PRAGMA integrity_check").getString();
  }

  TemporaryFolder folder_;
  ExperimentSettings settings_ = smallExperiment(folder_.path());
};

TEST_F(CrashTest, aKilledWriterLosesNothingCommitted)
{
  using std::chrono::microseconds;
  int64_t last = -1;
  for (const int delay : { 0, 50, 130, 210, 370, 590, 770, 1100, 1900, 3100, 20000 })
  {
    last = std::max(last, WriterProcess(settings_).killAfter(3, microseconds(delay)));
    const auto archive = openArchiveForWriting(settings_, someProvenance());
    // The one more was committed, but the process died before it told of it.
    const int64_t found = archive->trialStates().at(TRIAL).generation;
    EXPECT_TRUE(found == last || found == last + 1) << found << " after " << last;
    last = found;
    EXPECT_EQ(integrity(), "ok");
  }
  const auto archive = openArchiveForWriting(settings_, someProvenance());
  evolve(*archive, settings_, TRIAL, last + 3);

  TemporaryFolder other;
  const auto undisturbed = openArchiveForWriting(smallExperiment(other.path()), someProvenance());
  evolve(*undisturbed, smallExperiment(other.path()), TRIAL, last + 3);
  EXPECT_EQ(archive->digest(), undisturbed->digest());
  EXPECT_EQ(countRows(folder_.path(), "genomes"), countRows(other.path(), "genomes"));
}

TEST_F(CrashTest, aWriterKilledWhileItBeginsLeavesAFolderThatCanBeUsed)
{
  for (const int delay : { 100, 300, 600, 1000, 2000, 4000 })
  {
    settings_.output = folder_.path() + "/" + std::to_string(delay);
    WriterProcess(settings_).killAfter(0, std::chrono::microseconds(delay));
    const auto archive = openArchiveForWriting(settings_, someProvenance());
    evolve(*archive, settings_, TRIAL, 20);
    EXPECT_EQ(integrity(), "ok");
  }
}

TEST_F(CrashTest, anArchiveHasBegunOnceSomethingWasCommitted)
{
  EXPECT_FALSE(archiveHasBegun(settings_.output));
  EXPECT_FALSE(archiveHasBegun(settings_.output + "/nowhere"));
  doAndBeKilled([&] { connectForWriting(archivePath(settings_.output), 0); });
  ASSERT_TRUE(std::filesystem::exists(archivePath(settings_.output)));
  EXPECT_FALSE(archiveHasBegun(settings_.output));
  openArchiveForWriting(settings_, someProvenance());
  EXPECT_TRUE(archiveHasBegun(settings_.output));
}

TEST_F(CrashTest, readersUndoWhatAWriterBeganThatWasKilledWithoutALog)
{
  evolve(*openArchiveForWriting(settings_, someProvenance()), settings_, TRIAL, 50);
  const std::string digest = openArchiveForReading(settings_.output)->digest();
  doAndBeKilled(
      [&]
      {
        SQLite::Database database = openFile(settings_.output, SQLite::OPEN_READWRITE);
        database.exec("PRAGMA cache_size = 1; BEGIN IMMEDIATE; UPDATE individuals SET age = age + 1");
        raise(SIGKILL);  // a part of it is in the file already
      });
  ASSERT_TRUE(std::filesystem::exists(archivePath(settings_.output) + "-journal"));
  EXPECT_TRUE(archiveHasBegun(settings_.output));
  EXPECT_EQ(openArchiveForReading(settings_.output)->digest(), digest);
}

TEST_F(CrashTest, manyReadWhileOneWrites)
{
  WriterProcess writer(settings_);
  writer.nextCommit();
  const auto reader = openArchiveForReading(settings_.output);
  int64_t seen = 0;
  for (int i = 0; i < 20; ++i)
  {
    const int64_t committed = writer.nextCommit();
    const auto another = openArchiveForReading(settings_.output);
    const TrialState state = another->trialStates().at(TRIAL);
    EXPECT_GE(state.generation, committed);
    EXPECT_GE(state.generation, seen);
    EXPECT_EQ(state.survivors.size(), 8u);
    seen = state.generation;
    EXPECT_EQ(reader->digest().size(), 64u);
    reader->readLineage(TRIAL, reader->championOf(TRIAL));
  }
}

TEST_F(CrashTest, aSecondWriterIsRefusedUntilTheFirstIsDead)
{
  {
    WriterProcess first(settings_);
    first.nextCommit();
    const std::string message = messageOf<ArchiveError>([&] { openArchiveForWriting(settings_, someProvenance()); });
    EXPECT_NE(message.find("is in use: process "), std::string::npos) << message;
  }
  EXPECT_NO_THROW(openArchiveForWriting(settings_, someProvenance()));
}

TEST_F(CrashTest, theArchiveOfAKilledWriterCanBeRead)
{
  const int64_t last = WriterProcess(settings_).killAfter(5, std::chrono::microseconds(0));
  EXPECT_GE(openArchiveForReading(settings_.output)->trialStates().at(TRIAL).generation, last);
}

TEST_F(CrashTest, aFinishedArchiveIsOneFileAndReadingLeavesNothing)
{
  evolve(*openArchiveForWriting(settings_, someProvenance()), settings_, TRIAL, 5);
  openArchiveForReading(settings_.output)->digest();
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(settings_.output))
  {
    files.insert(entry.path().filename());
  }
  EXPECT_EQ(files, (std::set<std::string>{ "experiment.db", "experiment.lock" }));
}

TEST_F(CrashTest, aWriterMayEndWhileSomebodyReads)
{
  auto writer = openArchiveForWriting(settings_, someProvenance());
  evolve(*writer, settings_, TRIAL, 5);
  const auto reader = openArchiveForReading(settings_.output);
  const std::string digest = reader->digest();
  SQLite::Database other = openFile(settings_.output);
  SQLite::Statement reading(other, "SELECT id FROM individuals");
  reading.executeStep();
  writer.reset();
  EXPECT_EQ(reader->digest(), digest);
  reading.reset();
  evolve(*openArchiveForWriting(settings_, someProvenance()), settings_, TRIAL, 6);
  EXPECT_EQ(reader->trialStates().at(TRIAL).generation, 6);
}

TEST_F(CrashTest, copiesCanBeReadInAFolderThatMustNotBeWritten)
{
  const std::string finished = settings_.output + "/100% mine? #1";
  const std::string running = settings_.output + "/running";
  std::string digest;
  {
    const auto archive = openArchiveForWriting(settings_, someProvenance());
    evolve(*archive, settings_, TRIAL, 5);
    digest = archive->digest();
    openFile(settings_.output, SQLite::OPEN_READWRITE).exec("PRAGMA wal_checkpoint(TRUNCATE)");
    std::filesystem::create_directory(running);
    std::filesystem::copy(archivePath(settings_.output), archivePath(running));
  }
  std::filesystem::create_directory(finished);
  std::filesystem::copy(archivePath(settings_.output), archivePath(finished));
  chmod(settings_.output.c_str(), 0755);
  for (const std::string& folder : { finished, running })
  {
    chmod(folder.c_str(), 0555);
    EXPECT_TRUE(succeedsAsOrdinaryUser([&] { return openArchiveForReading(folder)->digest() == digest; })) << folder;
    chmod(folder.c_str(), 0755);
  }
}

TEST_F(CrashTest, whatAKilledWriterLeftCanBeReadByOthersOrTheySayWhyNot)
{
  const int64_t last = WriterProcess(settings_).killAfter(5, std::chrono::microseconds(0));
  chmod(settings_.output.c_str(), 0755);
  EXPECT_TRUE(succeedsAsOrdinaryUser(
      [&] { return openArchiveForReading(settings_.output)->trialStates().at(TRIAL).generation >= last; }));
  std::filesystem::remove(archivePath(settings_.output) + "-shm");
  EXPECT_TRUE(succeedsAsOrdinaryUser(
      [&]
      {
        return messageOf<ArchiveError>([&] { openArchiveForReading(settings_.output); }).find("copy both files") !=
               std::string::npos;
      }));
}
}  // namespace
}  // namespace devo_evo::test
