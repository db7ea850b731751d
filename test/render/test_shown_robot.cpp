#include "devo_evo/render/shown_robot.h"

#include "archive/test_tools.h"
#include "devo_evo/experiment/experiment.h"
#include "devo_evo/farm/local_farm.h"
#include "soft_body/robots.h"

#include <gtest/gtest.h>

#include <fstream>

namespace devo_evo
{
namespace
{
using test::messageOf;
using test::TemporaryFolder;

class Quiet : public ExperimentObserver
{
  void generationCommitted(const GenerationReport&) override {}
};

/// Evolves two trials of short-lived robots in a folder.
ExperimentSettings evolveIn(const std::string& output)
{
  ExperimentSettings settings;
  settings.output = output;
  settings.body.soft.lifetime = 0.2;
  settings.evolution.population = 4;
  settings.generations = 2;
  settings.trials = 2;
  const auto archive = openArchiveForWriting(settings, test::someProvenance());
  const auto farm = makeLocalFarm(makeBody(settings.body), 1);
  Quiet observer;
  Experiment(settings, *archive, *farm, observer).run();
  return settings;
}

TEST(RobotChoice, ReadsBestTrialsAndIndividuals)
{
  EXPECT_FALSE(parseRobotChoice("best").trial);
  EXPECT_EQ(parseRobotChoice("3").trial, 3);
  EXPECT_TRUE(parseRobotChoice("3").follows());
  EXPECT_EQ(parseRobotChoice("3/1042").trial, 3);
  EXPECT_EQ(parseRobotChoice("3/1042").id, 1042);
  EXPECT_FALSE(parseRobotChoice("3/1042").follows());
  for (const std::string text : { "best", "3", "3/1042", "1/0" })
  {
    EXPECT_EQ(toString(parseRobotChoice(text)), text);
  }
}

TEST(RobotChoice, RefusesEverythingElse)
{
  for (const std::string text :
       { "", "worst", "0", "-1", "3/", "/5", "3/-1", "3/x", "1/2/3", " 3", "3.5", "1e3", "99999999999999999999" })
  {
    EXPECT_NE(messageOf<InvalidInput>([&] { parseRobotChoice(text); }), "") << text;
  }
}

TEST(ShownRobot, OfAnArchiveLivesAsItsRecordSays)
{
  const TemporaryFolder folder;
  evolveIn(folder.path());
  const auto archive = openArchiveForReading(folder.path());
  for (const std::string choice : { "best", "1", "2", "1/0", "2/5" })
  {
    const auto robot = findRobot(*archive, parseRobotChoice(choice));
    ASSERT_TRUE(robot) << choice;
    ASSERT_TRUE(robot->recorded && robot->descent);
    EXPECT_EQ(robot->body.soft.lifetime, 0.2);
    const LifeSurvey life = surveyLife(*robot);
    EXPECT_EQ(disagreement(*robot, life.evaluation), "");
    EXPECT_EQ(life.evaluation.fitness, robot->recorded->fitness);
  }
}

TEST(ShownRobot, FollowsTheChampions)
{
  const TemporaryFolder folder;
  evolveIn(folder.path());
  const auto archive = openArchiveForReading(folder.path());
  const auto first = findRobot(*archive, parseRobotChoice("1"));
  const auto second = findRobot(*archive, parseRobotChoice("2"));
  const auto best = findRobot(*archive, parseRobotChoice("best"));
  EXPECT_EQ(first->descent->id, archive->championOf(1));
  EXPECT_EQ(second->descent->id, archive->championOf(2));
  EXPECT_EQ(best->recorded->fitness, std::max(first->recorded->fitness, second->recorded->fitness));
}

TEST(ShownRobot, ThatDoesNotExistIsRefused)
{
  const TemporaryFolder folder;
  evolveIn(folder.path());
  const auto archive = openArchiveForReading(folder.path());
  EXPECT_NE(messageOf<InvalidInput>([&] { findRobot(*archive, parseRobotChoice("1/4711")); }), "");
  EXPECT_NE(messageOf<InvalidInput>([&] { findRobot(*archive, parseRobotChoice("9/0")); }), "");
}

TEST(ShownRobot, OfAnEmptyArchiveIsNoneYet)
{
  const TemporaryFolder folder;
  openArchiveForWriting(test::smallExperiment(folder.path()), test::someProvenance());
  const auto archive = openArchiveForReading(folder.path());
  EXPECT_FALSE(findRobot(*archive, parseRobotChoice("best")));
  EXPECT_FALSE(findRobot(*archive, parseRobotChoice("1")));
  EXPECT_THROW(findRobot(*archive, parseRobotChoice("1/0")), InvalidInput);
}

TEST(ShownRobot, WithAnotherOutcomeThanRecordedIsFound)
{
  ShownRobot robot;
  robot.name = "1/7";
  robot.recorded = Evaluation();
  robot.recorded->valid = true;
  robot.recorded->fitness = 1.5;
  robot.recorded->state_hash = 0xabc;
  Evaluation evaluation = *robot.recorded;
  EXPECT_EQ(disagreement(robot, evaluation), "");
  evaluation.fitness = 1.5000000000000002;
  EXPECT_EQ(disagreement(robot, evaluation),
            "individual 1/7 is not what was recorded: simulated again it has fitness 1.5000000000000002 and state hash "
            "0000000000000abc, recorded is fitness 1.5 and state hash 0000000000000abc");
  evaluation = *robot.recorded;
  evaluation.state_hash = 0xabd;
  EXPECT_NE(disagreement(robot, evaluation), "");
  EXPECT_NE(disagreement(robot, Evaluation()).find("a simulation that diverged"), std::string::npos);
  robot.recorded.reset();
  EXPECT_EQ(disagreement(robot, evaluation), "");
}

TEST(RobotFile, GivesTheFirstOrTheOneThatIsNamed)
{
  const std::string path = TEST_DATA_DIR "/genomes.jsonl";
  EXPECT_EQ(readRobotFile(path, "", {}).name, "golden-000");
  const ShownRobot robot = readRobotFile(path, "golden-002", {});
  EXPECT_EQ(robot.name, "golden-002");
  EXPECT_EQ(robot.program.morphology_initial.size(), 48u);
  EXPECT_FALSE(robot.recorded || robot.descent);
}

TEST(RobotFile, SaysWhatIsWrong)
{
  const TemporaryFolder folder;
  const auto message = [](const std::string& path, const std::string& id)
  { return messageOf<InvalidInput>([&] { readRobotFile(path, id, {}); }); };
  EXPECT_NE(message(folder.path() + "/none.jsonl", "").find("cannot be read"), std::string::npos);
  EXPECT_NE(message(folder.path(), "").find("it is a folder"), std::string::npos);
  EXPECT_NE(message(TEST_DATA_DIR "/genomes.jsonl", "nobody").find("no robot called nobody"), std::string::npos);
  std::ofstream(folder.path() + "/empty.jsonl");
  EXPECT_NE(message(folder.path() + "/empty.jsonl", "").find("no robot in it"), std::string::npos);
  std::ofstream(folder.path() + "/bad.jsonl") << "{\"id\": 1, \"size_gene_initial\": [NaN]}";
  EXPECT_NE(message(folder.path() + "/bad.jsonl", "").find("line 1"), std::string::npos);
}

TEST(Caption, NamesTheRobotAndWhatItDoes)
{
  ShownRobot robot;
  robot.name = "3/1042";
  Evaluation evaluation;
  evaluation.valid = true;
  evaluation.fitness = 12.345;
  EXPECT_EQ(captionText(robot, evaluation, 3.2), "3/1042\nfitness 12.345 body lengths, 3.20 s");
  robot.descent = Descent{ 3, 1042, 412, 37, "evo_devo", 0.3, 0.4 };
  EXPECT_EQ(captionText(robot, evaluation, 3.2),
            "3/1042, evo_devo, generation 412, age 37\nfitness 12.345 body lengths, 3.20 s");
  EXPECT_EQ(captionText(robot, Evaluation(), 0.5), "3/1042, evo_devo, generation 412, age 37\ndiverges, 0.50 s");
}

TEST(LifeSurvey, KnowsHowFarTheRobotCame)
{
  ShownRobot robot;
  robot.body.soft.lifetime = 1.0;
  robot.program = scrambledRobot(robot.body.soft, 4);
  const LifeSurvey life = surveyLife(robot);
  const double end_y = life.birthplace.y() + life.evaluation.displacement_y_voxels * robot.body.soft.voxel_size;
  EXPECT_LE(life.extent.min().y(), end_y + 0.001);
  EXPECT_GE(life.extent.max().y(), end_y - 0.001);
}
}  // namespace
}  // namespace devo_evo
