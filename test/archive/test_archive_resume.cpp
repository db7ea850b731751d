// Who may write to an archive: the same experiment, one evolver at a time.

#include "devo_evo/archive/archive.h"

#include "archive/test_tools.h"

#include <gtest/gtest.h>

namespace devo_evo::test
{
namespace
{
class ResumeTest : public testing::Test
{
protected:
  ResumeTest() { openArchiveForWriting(settings_, someProvenance()); }

  std::string refusal(const ExperimentSettings& settings)
  {
    return messageOf<ArchiveError>([&] { openArchiveForWriting(settings, someProvenance()); });
  }

  TemporaryFolder folder_;
  ExperimentSettings settings_ = smallExperiment(folder_.path());
};

TEST_F(ResumeTest, settingsAreReadBackExactly)
{
  TemporaryFolder other;
  ExperimentSettings settings = smallExperiment(other.path());
  settings.body.soft.lifetime = 0.1 + 0.2;  // 0.30000000000000004
  settings.body.soft.self_collision = false;
  settings.evolution.treatment = Treatment::EVO;
  settings.evolution.profile = Profile::RELEASED_CODE;
  settings.evolution.mutation_rate = 1.0 / 3.0;
  settings.evolution.seed = 9223372036854775807;
  settings.trials = 5;
  const ExperimentSettings archived = openArchiveForWriting(settings, someProvenance())->settings();
  EXPECT_EQ(archived.output, other.path());
  EXPECT_EQ(archived.body.soft.lifetime, settings.body.soft.lifetime);
  EXPECT_EQ(archived.body.soft.grid_x, 2);
  EXPECT_FALSE(archived.body.soft.self_collision);
  EXPECT_EQ(archived.evolution.treatment, Treatment::EVO);
  EXPECT_EQ(archived.evolution.profile, Profile::RELEASED_CODE);
  EXPECT_EQ(archived.evolution.mutation_rate, settings.evolution.mutation_rate);
  EXPECT_EQ(archived.evolution.seed, settings.evolution.seed);
  EXPECT_EQ(archived.evolution.population, 8);
  EXPECT_EQ(archived.trials, 5);
}

TEST_F(ResumeTest, theSameExperimentIsResumed)
{
  EXPECT_EQ(refusal(settings_), "");
}

TEST_F(ResumeTest, everyDifferenceIsNamedWithBothValues)
{
  ExperimentSettings other = settings_;
  other.body.soft.lifetime = 5.0;
  other.evolution.treatment = Treatment::EVO;
  other.evolution.mutation_rate = 0.5;
  const std::string message = refusal(other);
  EXPECT_NE(message.find("lifetime is 10 there and 5 here"), std::string::npos) << message;
  EXPECT_NE(message.find("treatment is evo_devo there and evo here"), std::string::npos) << message;
  EXPECT_NE(message.find("mutation_rate is self_adaptive there and 0.5 here"), std::string::npos) << message;
}

TEST_F(ResumeTest, whateverDecidesTheResultsMustAgree)
{
  const std::vector<void (*)(ExperimentSettings&)> changes = {
    [](ExperimentSettings& settings) { settings.body.soft.grid_z = 2; },
    [](ExperimentSettings& settings) { settings.body.soft.lifetime = 9.0; },
    [](ExperimentSettings& settings) { settings.body.soft.gravity = 1.6; },
    [](ExperimentSettings& settings) { settings.body.soft.self_collision = false; },
    [](ExperimentSettings& settings) { settings.evolution.treatment = Treatment::EVO; },
    [](ExperimentSettings& settings) { settings.evolution.profile = Profile::RELEASED_CODE; },
    [](ExperimentSettings& settings) { settings.evolution.mutation_rate = 0.1; },
    [](ExperimentSettings& settings) { settings.evolution.population = 9; },
    [](ExperimentSettings& settings) { settings.evolution.seed = 2; },
  };
  for (size_t i = 0; i < changes.size(); ++i)
  {
    ExperimentSettings other = settings_;
    changes[i](other);
    EXPECT_NE(refusal(other), "") << "change " << i;
  }
}

TEST_F(ResumeTest, trialsAndGenerationsMayChange)
{
  ExperimentSettings more = settings_;
  more.trials = 3;
  more.generations = 100;
  EXPECT_EQ(openArchiveForWriting(more, someProvenance())->settings().trials, 3);
  EXPECT_EQ(openArchiveForReading(settings_.output)->settings().generations, 100);
}

TEST_F(ResumeTest, fewerGenerationsThanCommittedRemoveNothing)
{
  std::string digest;
  {
    const auto archive = openArchiveForWriting(settings_, someProvenance());
    evolve(*archive, settings_, 1, 6);
    evolve(*archive, settings_, 2, 4);
    digest = archive->digest();
  }
  ExperimentSettings fewer = settings_;
  fewer.generations = 5;
  fewer.trials = 1;
  const auto archive = openArchiveForWriting(fewer, someProvenance());
  EXPECT_EQ(archive->settings().generations, 6);
  EXPECT_EQ(archive->settings().trials, 2);
  EXPECT_EQ(archive->digest(), digest);
}

TEST_F(ResumeTest, everyStartIsNoted)
{
  Provenance elsewhere = someProvenance();
  elsewhere.host = "elsewhere";
  openArchiveForWriting(settings_, elsewhere);
  SQLite::Database file = openFile(settings_.output);
  EXPECT_EQ(file.execAndGet("SELECT group_concat(host) FROM starts ORDER BY number").getString(),
            "laboratory,elsewhere");
  EXPECT_EQ(file.execAndGet("SELECT count(*) FROM starts WHERE time_utc LIKE '20__-__-__T__:__:__Z'").getInt(), 2);
}

TEST_F(ResumeTest, anotherEngineIsRefused)
{
  Provenance other = someProvenance();
  other.engine_fingerprint = 0x1235;
  const std::string message = messageOf<ArchiveError>([&] { openArchiveForWriting(settings_, other); });
  EXPECT_NE(message.find("0000000000001234"), std::string::npos) << message;
  EXPECT_NE(message.find("0000000000001235"), std::string::npos) << message;
  EXPECT_EQ(countRows(settings_.output, "starts"), 1);

  other.engine_fingerprint = 0;
  EXPECT_NO_THROW(openArchiveForWriting(settings_, other));
}

TEST_F(ResumeTest, aParameterThatTheArchiveDoesNotKnowHadItsDefaultValue)
{
  openFile(settings_.output, SQLite::OPEN_READWRITE).exec("DELETE FROM parameters WHERE name = 'self_collision'");
  EXPECT_EQ(refusal(settings_), "");
  openFile(settings_.output, SQLite::OPEN_READWRITE).exec("DELETE FROM parameters WHERE name = 'self_collision'");
  settings_.body.soft.self_collision = false;
  EXPECT_NE(refusal(settings_).find("self_collision is true there and false here"), std::string::npos);
}

TEST_F(ResumeTest, aSecondWriterIsRefusedWithTheFirstOnesName)
{
  const auto first = openArchiveForWriting(settings_, someProvenance());
  const std::string message = refusal(settings_);
  EXPECT_NE(message.find("process " + std::to_string(getpid()) + " on host "), std::string::npos) << message;
  evolve(*first, settings_, 1, 1);
}

TEST_F(ResumeTest, aWriterMayFollowAnother)
{
  openArchiveForWriting(settings_, someProvenance());
  EXPECT_EQ(refusal(settings_), "");
}
}  // namespace
}  // namespace devo_evo::test
