// The digest, computed a second time from SQL alone, as docs/archive.md describes it.

#include "devo_evo/archive/archive.h"

#include "archive/test_tools.h"

#include <gtest/gtest.h>
#include <openssl/sha.h>

#include <cstring>
#include <iomanip>
#include <sstream>

namespace devo_evo::test
{
namespace
{
void append(std::string& dump, int64_t number)
{
  for (int shift = 0; shift < 64; shift += 8)
  {
    dump += static_cast<char>(static_cast<uint64_t>(number) >> shift & 0xff);
  }
}

void append(std::string& dump, double number)
{
  int64_t bits;
  std::memcpy(&bits, &number, sizeof(bits));
  append(dump, bits);
}

std::string reversed(const std::string& text)
{
  return std::string(text.rbegin(), text.rend());
}

std::string dumpGeneration(SQLite::Database& file, int64_t trial, int64_t generation)
{
  std::string dump;
  append(dump, trial);
  append(dump, generation);

  SQLite::Statement newcomers(file,
                              "SELECT id, ifnull(parent, -1), age, genome_hash, valid, ifnull(fitness, 0.0), "
                              "ifnull(state_hash, zeroblob(8)), count(*) OVER () FROM individuals "
                              "WHERE trial = ? AND generation = ? ORDER BY id");
  newcomers.bind(1, trial);
  newcomers.bind(2, generation);
  for (bool first = true; newcomers.executeStep(); first = false)
  {
    if (first)
    {
      append(dump, newcomers.getColumn(7).getInt64());
    }
    append(dump, newcomers.getColumn(0).getInt64());
    append(dump, newcomers.getColumn(1).getInt64());
    append(dump, newcomers.getColumn(2).getInt64());
    dump += newcomers.getColumn(3).getString();
    dump += static_cast<char>(newcomers.getColumn(4).getInt());
    append(dump, newcomers.getColumn(5).getDouble());
    dump += reversed(newcomers.getColumn(6).getString());
  }

  SQLite::Statement survivors(file,
                              "SELECT id, count(*) OVER () FROM survivors WHERE trial = ? AND generation = ? "
                              "ORDER BY rank");
  survivors.bind(1, trial);
  survivors.bind(2, generation);
  for (bool first = true; survivors.executeStep(); first = false)
  {
    if (first)
    {
      append(dump, survivors.getColumn(1).getInt64());
    }
    append(dump, survivors.getColumn(0).getInt64());
  }
  return dump;
}

std::string digestFromSql(const std::string& output)
{
  SQLite::Database file = openFile(output);
  std::string dump = "devo_evo digest 1\n";
  SQLite::Statement generations(file, "SELECT trial, generation FROM generations ORDER BY trial, generation");
  while (generations.executeStep())
  {
    dump += dumpGeneration(file, generations.getColumn(0).getInt64(), generations.getColumn(1).getInt64());
  }
  unsigned char hash[SHA256_DIGEST_LENGTH];
  SHA256(reinterpret_cast<const unsigned char*>(dump.data()), dump.size(), hash);
  std::ostringstream text;
  for (const unsigned char byte : hash)
  {
    text << std::hex << std::setw(2) << std::setfill('0') << static_cast<int>(byte);
  }
  return text.str();
}

class DigestTest : public testing::Test
{
protected:
  std::string digestOf(const std::vector<int64_t>& trials, int64_t generations, int64_t seed = 1,
                       const Provenance& provenance = someProvenance())
  {
    const TemporaryFolder folder;
    ExperimentSettings settings = smallExperiment(folder.path());
    settings.evolution.seed = seed;
    const auto archive = openArchiveForWriting(settings, provenance);
    for (const int64_t trial : trials)
    {
      evolve(*archive, settings, trial, generations);
    }
    const std::string digest = archive->digest();
    EXPECT_EQ(digest, digestFromSql(folder.path()));
    EXPECT_EQ(digest, openArchiveForReading(folder.path())->digest());
    return digest;
  }
};

TEST_F(DigestTest, ofNothingIsThatOfTheHeading)
{
  // printf 'devo_evo digest 1\n' | sha256sum
  EXPECT_EQ(digestOf({}, 0), "7563ba554a32cd12c95493a0d9ff45f5e9ffa8c84b09b93ac52a254ca06ebbda");
}

TEST_F(DigestTest, equalsTheOneComputedFromSql)
{
  EXPECT_EQ(digestOf({ 1 }, 0).size(), 64u);
  digestOf({ 1 }, 12);
  digestOf({ 1, 2, 10 }, 5);
}

TEST_F(DigestTest, doesNotDependOnOrderOrPlace)
{
  Provenance elsewhere;
  elsewhere.host = "elsewhere";
  EXPECT_EQ(digestOf({ 1, 2, 3 }, 5), digestOf({ 3, 1, 2 }, 5, 1, elsewhere));
}

TEST_F(DigestTest, dependsOnSeedGenerationsAndTrials)
{
  const std::string digest = digestOf({ 1 }, 5);
  EXPECT_NE(digest, digestOf({ 1 }, 5, 2));
  EXPECT_NE(digest, digestOf({ 1 }, 6));
  EXPECT_NE(digest, digestOf({ 2 }, 5));
  EXPECT_NE(digest, digestOf({ 1, 2 }, 5));
}

TEST_F(DigestTest, noticesEveryDecision)
{
  const TemporaryFolder folder;
  const ExperimentSettings settings = smallExperiment(folder.path());
  const auto archive = openArchiveForWriting(settings, someProvenance());
  evolve(*archive, settings, 1, 3);
  std::string digest = archive->digest();
  for (const std::string change :
       { "individuals SET parent = 1 WHERE id = 9", "individuals SET age = age + 1 WHERE id = 3",
         "individuals SET genome_hash = zeroblob(16) WHERE id = 4",
         "individuals SET fitness = fitness + 1e-12 WHERE id = 5",
         "individuals SET state_hash = zeroblob(8) WHERE id = 6",
         "survivors SET id = 0 WHERE generation = 2 AND rank = 3" })
  {
    openFile(folder.path(), SQLite::OPEN_READWRITE).exec("UPDATE " + change);
    const std::string changed = archive->digest();
    EXPECT_NE(changed, digest) << change;
    digest = changed;
  }
}
}  // namespace
}  // namespace devo_evo::test
