// Whole studies, on evaluations that are made up and take no time.
#include "study/study_tools.h"

#include "archive/bytes.h"
#include "archive/schema.h"
#include "devo_evo/farm/local_farm.h"
#include "study/arms.h"
#include "study/study_database.h"
#include "study/workload.h"

#include <gtest/gtest.h>

namespace devo_evo::test
{
namespace
{
/// Runs a study to its end, with real lives.
void simulate(const Parameters& study)
{
  CountingObserver observer;
  const auto make_farm = [](const BodySettings& body) { return makeLocalFarm(makeBody(body), 1); };
  ASSERT_EQ(runStudy(study, someProvenance(), make_farm, observer), RunOutcome::FINISHED);
}

class StudyTest : public testing::Test
{
protected:
  double value(const std::string& sql) const { return valueOf(folder_.path(), sql); }

  TemporaryFolder folder_;
  Parameters study_ = smallStudy(folder_.path());
};

/// Tests that only look at a finished study share one.
class FinishedStudyTest : public testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    folder = new TemporaryFolder;
    said = runSmall(smallStudy(folder->path()));
  }
  static void TearDownTestSuite() { delete folder; }

  static double value(const std::string& sql) { return valueOf(folder->path(), sql); }

  static inline TemporaryFolder* folder = nullptr;
  static inline std::string said;
};

TEST_F(FinishedStudyTest, evolvedEveryArmAsAnOrdinaryExperiment)
{
  const Parameters study = smallStudy(folder->path());
  size_t arms = 0;
  for (const StudyPart part : { StudyPart::MAIN, StudyPart::BASELINES, StudyPart::SWEEP })
  {
    for (const Arm& arm : armsOf(part, study))
    {
      ++arms;
      TemporaryFolder alone;
      ExperimentSettings settings = arm.settings;
      settings.output = alone.path();
      const auto archive = openArchiveForWriting(settings, someProvenance());
      for (int64_t trial = 1; trial <= settings.trials; ++trial)
      {
        evolve(*archive, settings, trial, settings.generations);
      }
      EXPECT_EQ(archive->digest(), openArchiveForReading(folder->path() + "/" + arm.name)->digest()) << arm.name;
      EXPECT_NE(said.find(arm.name + ": digest " + archive->digest() + "\n"), std::string::npos);
    }
  }
  EXPECT_EQ(arms, 2u + 4u + 4u);
  EXPECT_EQ(value("SELECT count(*) FROM arms"), 10);
}

TEST_F(FinishedStudyTest, holdsEveryAnalysisOfEveryRunChampion)
{
  EXPECT_EQ(value("SELECT count(*) FROM champions"), 4);
  EXPECT_EQ(value("SELECT count(*) FROM champion_variants"), 2 * 9);  // Evo-Devo's
  // Two spaces; Evo has two kinds of walks, Evo-Devo three.
  EXPECT_EQ(value("SELECT count(*) FROM champion_walks"), 2 * 2 * (2 + 3) * 2 * 6);
  EXPECT_EQ(value("SELECT count(*) FROM champion_traces"), 4 * 2);
  EXPECT_EQ(value("SELECT count(*) FROM champion_robustness"), 4 * 4);
  EXPECT_EQ(value("SELECT count(*) FROM neutral_lineages"), 2 * 3);
  EXPECT_EQ(value("SELECT count(*) FROM mutational_impact"), 4 * 2);
  EXPECT_EQ(value("SELECT count(*) FROM champion_ancestors WHERE position = 0"), 4);
  EXPECT_EQ(value("SELECT count(*) FROM champion_ancestors WHERE id = champion"), 4);
}

TEST_F(FinishedStudyTest, keepsWhatWasSimulatedWithWhereItComesFrom)
{
  SQLite::Database database = openStudy(folder->path());
  SQLite::Statement rows(database,
                         "SELECT trial, id, fitness, velocities, world FROM champion_robustness WHERE arm = "
                         "'main/evo_devo' AND name = 'slope=0.5'");
  const auto archive = openArchiveForReading(folder->path() + "/main/evo_devo");
  int seen = 0;
  while (rows.executeStep())
  {
    ++seen;
    const int64_t trial = rows.getColumn(0).getInt64(), id = rows.getColumn(1).getInt64();
    EXPECT_EQ(id, archive->championOf(trial));
    const Evaluation evaluation = madeUpEvaluation(archive->readIndividual(trial, id).individual.genome.program);
    EXPECT_EQ(rows.getColumn(2).getDouble(), evaluation.fitness - 0.5);
    const auto* bytes = static_cast<const uint8_t*>(rows.getColumn(3).getBlob());
    EXPECT_EQ(numbersFromBytes(Blob(bytes, bytes + rows.getColumn(3).size())), (std::vector<double>{ 0.5, 0.25 }));
  }
  EXPECT_EQ(seen, 2);
  EXPECT_EQ(value("SELECT count(*) FROM evaluations LEFT JOIN starts ON number = start WHERE number IS NULL"), 0);
  EXPECT_EQ(value("SELECT count(*) FROM worlds WHERE json_extract(settings, '$.slope') = 0.5 AND "
                  "json_extract(settings, '$.grid') = '2x2x1'"),
            1);
}

TEST_F(FinishedStudyTest, hasRobotsThatDivergedWithoutResults)
{
  EXPECT_GT(value("SELECT count(*) FROM champion_walks WHERE NOT valid AND fitness IS NULL"), 0);
}

TEST_F(StudyTest, isTheSameHoweverOftenItIsStopped)
{
  TemporaryFolder undisturbed;
  runSmall(smallStudy(undisturbed.path()));
  int stops = 0;
  for (int64_t patience = 3;; patience += 4)  // a little farther every time
  {
    CountingObserver observer(patience);
    const auto make_farm = [](const BodySettings& body) { return std::make_unique<MadeUpFarm>(body.soft); };
    if (runStudy(study_, someProvenance(), make_farm, observer) == RunOutcome::FINISHED)
    {
      break;
    }
    ++stops;
  }
  EXPECT_GT(stops, 5);
  EXPECT_EQ(contentOfStudy(folder_.path()), contentOfStudy(undisturbed.path()));
}

TEST_F(StudyTest, goesOnWhereItWasKilledBetweenMakingAFileAndItsFirstCommit)
{
  std::vector<std::string> files = { studyDatabasePath(folder_.path()) };
  for (const StudyPart part : { StudyPart::MAIN, StudyPart::PARTIAL, StudyPart::BASELINES, StudyPart::SWEEP })
  {
    for (const Arm& arm : armsOf(part, study_))
    {
      std::filesystem::create_directories(arm.settings.output);
      files.push_back(archivePath(arm.settings.output));
    }
  }
  for (const std::string& file : files)
  {
    doAndBeKilled([&] { connectForWriting(file, 0); });
    ASSERT_TRUE(std::filesystem::exists(file));
  }
  EXPECT_NE(estimateText(study_, 1, InstructionSet::SCALAR), "");
  runSmall(study_);
  TemporaryFolder undisturbed;
  runSmall(smallStudy(undisturbed.path()));
  EXPECT_EQ(contentOfStudy(folder_.path()), contentOfStudy(undisturbed.path()));
  EXPECT_NE(estimateText(study_, 1, InstructionSet::SCALAR), "");
}

TEST_F(StudyTest, doesNothingTwice)
{
  study_.study.only = { StudyPart::MAIN, StudyPart::REMOVED, StudyPart::WALKS, StudyPart::LINEAGES, StudyPart::IMPACT };
  runSmall(study_);
  const double starts = value("SELECT count(*) FROM starts");
  const std::string content = contentOfStudy(folder_.path());
  const auto no_farm = [](const BodySettings& /*body*/) -> std::unique_ptr<Farm>
  { throw std::logic_error("everything is known already"); };
  CountingObserver observer;
  EXPECT_EQ(runStudy(study_, someProvenance(), no_farm, observer), RunOutcome::FINISHED);
  EXPECT_EQ(contentOfStudy(folder_.path()), content);
  EXPECT_EQ(value("SELECT count(*) FROM starts"), starts + 1);
}

TEST_F(StudyTest, growsAndIsAboutTheNewChampionsThen)
{
  study_.study.only = { StudyPart::MAIN, StudyPart::WALKS, StudyPart::LINEAGES, StudyPart::TRACES };
  runSmall(study_);
  study_.experiment.generations = 12;
  study_.study.walks = 3;
  study_.study.walk_steps = 8;
  runSmall(study_);
  EXPECT_EQ(value("SELECT min(generation) FROM champions"), 12);
  EXPECT_EQ(value("SELECT count(*) FROM champion_walks WHERE arm = 'main/evo'"), 2 * 2 * 2 * 3 * 9);
  EXPECT_EQ(value("SELECT count(*) FROM champion_ancestors WHERE id = champion"), 4);
  EXPECT_GE(value("SELECT count(*) FROM traces"), value("SELECT count(*) FROM champion_traces"));
}

TEST_F(StudyTest, evolvesTheOtherTreatmentsIfAskedAndAnalysesThemToo)
{
  study_.study.only = { StudyPart::MAIN, StudyPart::PARTIAL };
  runSmall(study_);
  study_.study.only = { StudyPart::REMOVED };
  runSmall(study_);
  EXPECT_EQ(value("SELECT count(*) FROM champion_variants WHERE arm = 'partial/evo_devo_control'"), 2 * 9);
  EXPECT_EQ(value("SELECT max(morphology_window) FROM champion_variants WHERE arm = 'partial/evo_devo_control'"), 0);
}

TEST_F(StudyTest, evolvesRigidBodiesWhateverIsSaidOfVoxels)
{
  study_.study.only = { StudyPart::RIGID };
  study_.study.rigid_trials = 2;
  study_.study.rigid_generations = 1;
  study_.experiment.evolution.profile = Profile::RELEASED_CODE;
  study_.experiment.evolution.mutation_rate = 0.25;
  simulate(study_);
  for (const std::string treatment : { "evo", "evo_devo" })
  {
    const auto archive = openArchiveForReading(folder_.path() + "/rigid/" + treatment);
    EXPECT_EQ(archive->settings().body.kind, BodyKind::RIGID);
    EXPECT_EQ(archive->trials(), (std::vector<int64_t>{ 1, 2 }));
    const ArchivedIndividual champion = archive->readIndividual(1, archive->championOf(1));
    EXPECT_EQ(champion.individual.genome.program.morphology_initial.size(), 4u);
    EXPECT_EQ(champion.morphology_window > 0.0, treatment == "evo_devo");
  }
}

TEST_F(StudyTest, takesTheWorldOfRigidBodiesAsItTakesThatOfVoxels)
{
  study_.study.only = { StudyPart::MAIN, StudyPart::RIGID };
  study_.study.rigid_trials = 1;
  study_.study.rigid_generations = 0;
  study_.experiment.body.rigid.slope = 5.0;
  study_.experiment.body.rigid.lifetime = 0.5;
  study_.experiment.evolution.rigid_mutation_sigma = 0.25;
  study_.experiment.generations = 0;
  simulate(study_);
  const ExperimentSettings rigid = openArchiveForReading(folder_.path() + "/rigid/evo")->settings();
  EXPECT_EQ(rigid.body.rigid.slope, 5.0);
  EXPECT_EQ(rigid.evolution.rigid_mutation_sigma, 0.25);
  EXPECT_EQ(rigid.body.soft.grid_x, SoftBodySettings().grid_x);
  EXPECT_EQ(openArchiveForReading(folder_.path() + "/main/evo")->settings().body.soft.grid_x, 2);
  EXPECT_EQ(value("SELECT value FROM parameters WHERE name = 'rigid_slope'"), 5);

  study_.study.only = { StudyPart::IMPACT };
  study_.experiment.body.rigid.slope = 4.0;
  EXPECT_NE(messageOf<ArchiveError>([&] { runSmall(study_); }).find("rigid_slope is 5 there and 4 here"),
            std::string::npos);
  study_.experiment.body.rigid.time_step = 1.0;
  EXPECT_EQ(messageOf<InvalidInput>([&] { runSmall(study_); }),
            "rigid_time_step is 1; it must lie within 1e-05 to 0.05");
}

TEST_F(StudyTest, saysWhatAPartNeeds)
{
  study_.study.only = { StudyPart::WALKS };
  EXPECT_EQ(messageOf<InvalidInput>([&] { runSmall(study_); }),
            "there is no generation in " + folder_.path() +
                "/main/evo/experiment.db: analyses are about its champions; run the part main first");
}

TEST_F(StudyTest, leavesAnotherStudyAlone)
{
  study_.study.only = { StudyPart::IMPACT };
  runSmall(study_);
  study_.experiment.body.soft.lifetime = 3.0;
  EXPECT_NE(messageOf<ArchiveError>([&] { runSmall(study_); }).find("lifetime is 10 there and 3 here"),
            std::string::npos);
}

TEST_F(StudyTest, choosesTreatmentsItself)
{
  study_.experiment.evolution.treatment = Treatment::EVO;
  EXPECT_THROW(runSmall(study_), InvalidInput);
  study_.experiment.evolution = {};
  study_.experiment.evolution.selection = Selection::NEUTRAL;
  EXPECT_THROW(runSmall(study_), InvalidInput);
}

TEST_F(StudyTest, tellsWorldsApartThatCannotBe)
{
  study_.study.amplitude_factors = { 4 };
  EXPECT_EQ(messageOf<InvalidInput>([&] { runSmall(study_); }).find("robustness, actuation_amplitude*4: "), 0u);
}

TEST_F(StudyTest, stopsWhenALineageDoesNotComeOutAsItsArchiveSays)
{
  study_.study.only = { StudyPart::MAIN };
  runSmall(study_);
  openFile(folder_.path() + "/main/evo", SQLite::OPEN_READWRITE)
      .exec("UPDATE individuals SET state_hash = zeroblob(8) WHERE valid");
  study_.study.only = { StudyPart::LINEAGES };
  EXPECT_NE(messageOf<ArchiveError>([&] { runSmall(study_); }).find("ended otherwise when it was simulated again"),
            std::string::npos);
}

TEST_F(StudyTest, estimatesWhatIsLeft)
{
  const auto left = [&](StudyPart part)
  {
    for (const Workload& load : workloads(study_))
    {
      if (load.part == part)
      {
        return load.left;
      }
    }
    return int64_t{ -1 };
  };
  EXPECT_EQ(left(StudyPart::MAIN), 2 * 2 * (8 + 6 * 9));
  EXPECT_EQ(left(StudyPart::BASELINES), 4 * (8 + 3 * 9));
  EXPECT_EQ(left(StudyPart::SWEEP), 4 * (8 + 2 * 9));
  EXPECT_EQ(left(StudyPart::WALKS), 2 * 2 * (2 + 3) * 2 * 6);
  EXPECT_EQ(left(StudyPart::REMOVED), 2 * 9);
  EXPECT_EQ(left(StudyPart::ROBUSTNESS), 4 * 4);
  EXPECT_EQ(left(StudyPart::PARTIAL), -1);
  study_.study.only = { StudyPart::MAIN, StudyPart::WALKS, StudyPart::SWEEP };
  runSmall(study_);
  study_.study.walks = 3;
  EXPECT_EQ(left(StudyPart::MAIN), 0);
  EXPECT_EQ(left(StudyPart::WALKS), 2 * 2 * (2 + 3) * 6);
  EXPECT_NE(estimateText(study_, 1, InstructionSet::SCALAR).find("sweep                 104            0   0 s\n"),
            std::string::npos);
}
}  // namespace
}  // namespace devo_evo::test
