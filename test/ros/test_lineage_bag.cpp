#include "ros/picture/lineage_bag.h"

#include "archive/test_tools.h"
#include "cli/bag_film.h"
#include "devo_evo/experiment/experiment.h"
#include "devo_evo/farm/local_farm.h"
#include "devo_evo/render/life_playback.h"
#include "ros/message_fields.h"

#include <devo_evo/EvolvedRobot.h>
#include <devo_evo/VelocityTelemetry.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <std_msgs/String.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <gtest/gtest.h>

#include <filesystem>
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

/// What a bag tells of one life.
struct RecordedLife
{
  EvolvedRobot individual;
  std::vector<double> y;        ///< of the centre of mass in each picture [m]
  std::vector<size_t> corners;  ///< of the body's triangles in each picture
  VelocityTelemetry velocity;
  double first_stamp = 0.0, last_stamp = 0.0;
};

class LineageBag : public ::testing::Test
{
protected:
  LineageBag()
  {
    settings_.output = folder_.path() + "/run";
    settings_.body.soft.lifetime = 0.3;
    settings_.evolution.population = 4;
    settings_.generations = 6;
    evolve();
  }

  void evolve() const
  {
    const auto archive = openArchiveForWriting(settings_, test::someProvenance());
    const auto farm = makeLocalFarm(makeBody(settings_.body), 1);
    Quiet observer;
    Experiment(settings_, *archive, *farm, observer).run();
  }

  std::vector<RecordedLife> record(const LineageBagOptions& options)
  {
    const auto archive = openArchiveForReading(settings_.output);
    lineage_ = readLineage(*archive, std::nullopt, std::nullopt);
    writeLineageBag(*archive, lineage_, options, path_, [](size_t, size_t) {});
    return read();
  }

  std::vector<RecordedLife> read() const
  {
    rosbag::Bag bag(path_);
    std::vector<RecordedLife> lives;
    ros::Time last(1.0);
    for (const rosbag::MessageInstance& message : rosbag::View(bag))
    {
      EXPECT_GE(message.getTime(), last) << "time never goes back, and begins at 1 s";
      last = message.getTime();
      if (const auto individual = message.instantiate<EvolvedRobot>())
      {
        lives.emplace_back();
        lives.back().individual = *individual;
        lives.back().first_stamp = last.toSec();
      }
      if (const auto transforms = message.instantiate<tf2_msgs::TFMessage>())
      {
        lives.back().y.push_back(transforms->transforms.at(0).transform.translation.y);
        EXPECT_EQ(transforms->transforms[0].child_frame_id, "lineage/robot");
        EXPECT_EQ(transforms->transforms[1].child_frame_id, "lineage/follow");
        lives.back().last_stamp = last.toSec();
      }
      const auto markers = message.instantiate<visualization_msgs::MarkerArray>();
      if (markers && message.getTopic() == "/lineage/robot")
      {
        lives.back().corners.push_back(markers->markers.at(0).points.size());
      }
      if (const auto velocity = message.instantiate<VelocityTelemetry>())
      {
        lives.back().velocity = *velocity;
      }
    }
    return lives;
  }

  const TemporaryFolder folder_;
  const std::string path_ = folder_.path() + "/lineage.bag";
  ExperimentSettings settings_;
  Lineage lineage_;
};

TEST_F(LineageBag, HoldsTheLivesOfTheArchiveFounderFirst)
{
  std::vector<RecordedLife> lives = record(LineageBagOptions());
  ASSERT_EQ(lives.size(), lineage_.individuals.size());
  for (size_t i = 0; i < lives.size(); ++i)
  {
    const Individual& archived = lineage_.individuals[i].individual;
    RecordedLife& life = lives[i];
    EXPECT_EQ(life.individual.id, archived.id);
    EXPECT_EQ(test::elementNamed(life.individual.genome.arrays, "size_gene_initial").values,
              archived.genome.program.morphology_initial);
    EXPECT_EQ(life.individual.morphology_window, lineage_.individuals[i].morphology_window);
    ASSERT_EQ(life.y.size(), 9u) << "25 a second for 0.3 s, at birth and at the end";
    const double displacement = (life.y.back() - life.y.front()) / settings_.body.soft.voxel_size;
    EXPECT_EQ(displacement / settings_.body.soft.grid_y, archived.evaluation->fitness) << "to the last bit";
    EXPECT_EQ(life.velocity.id, archived.id);
    EXPECT_EQ(life.velocity.velocity.size(), 1u);
    EXPECT_EQ(life.corners.front(), 80u * 6) << "80 outer faces of 4 x 4 x 3 voxels, two triangles each";
  }
}

TEST_F(LineageBag, PausesBetweenLives)
{
  LineageBagOptions options;
  options.pause = 2.5;
  options.count = 2;
  const std::vector<RecordedLife> lives = record(options);
  ASSERT_EQ(lives.size(), 2u);
  EXPECT_NEAR(lives[0].first_stamp, 1.0, 1e-9);
  EXPECT_NEAR(lives[1].first_stamp - lives[0].last_stamp, 2.5, 1e-6);
  EXPECT_EQ(lives[1].individual.id, lineage_.individuals.back().individual.id);
}

TEST_F(LineageBag, TakesLessThanAMegabyteForTenSecondsOfLife)
{
  settings_.output += "_of_long_lives";
  settings_.body.soft.lifetime = 10.0;
  settings_.evolution.population = 2;
  settings_.generations = 0;
  evolve();
  ASSERT_EQ(record(LineageBagOptions()).size(), 1u);
  EXPECT_LT(std::filesystem::file_size(path_), 1000000u);
}

TEST_F(LineageBag, TakesLessThanAMegabyteForARobotThatRolls)
{
  settings_.output += "_of_a_roller";
  settings_.body.soft.lifetime = 10.0;
  settings_.evolution.profile = Profile::RELEASED_CODE;
  settings_.evolution.population = 2;
  settings_.generations = 0;
  settings_.founders = folder_.path() + "/roller.jsonl";
  std::ifstream robots(TEST_DATA_DIR "/genomes.jsonl");
  for (std::string line; std::getline(robots, line);)
  {
    if (line.find("\"roller-11\"") != std::string::npos)
    {
      std::ofstream(settings_.founders) << line << '\n';
    }
  }
  loadFounders(settings_);
  evolve();
  std::vector<RecordedLife> lives = record(LineageBagOptions());
  ASSERT_EQ(lives.size(), 1u);
  EXPECT_GT(test::elementNamed(lives[0].individual.evaluation.measures, "turns").value, 20.0);
  EXPECT_LT(std::filesystem::file_size(path_), 1000000u);
}

TEST_F(LineageBag, CanBeFilmed)
{
  LineageBagOptions options;
  options.count = 2;
  record(options);
  PictureFormat format;
  format.width = 160;
  format.height = 90;
  int64_t pictures = 0;
  filmBag(path_, folder_.path() + "/film/", format, [&](int64_t done, int64_t) { pictures = done; });
  EXPECT_GT(pictures, 25);
  EXPECT_TRUE(std::filesystem::exists(folder_.path() + "/film/00020.png"));
}

TEST_F(LineageBag, SaysWhereItCannotBeWritten)
{
  const auto archive = openArchiveForReading(settings_.output);
  const Lineage lineage = readLineage(*archive, 1, std::nullopt);
  EXPECT_NE(messageOf<std::runtime_error>(
                [&] { writeLineageBag(*archive, lineage, {}, "/nowhere/l.bag", [](size_t, size_t) {}); })
                .find("/nowhere/l.bag"),
            std::string::npos);
  LineageBagOptions options;
  options.pause = 0.0;
  EXPECT_NE(messageOf<InvalidInput>([&] { record(options); }).find("pause"), std::string::npos);
}

TEST_F(LineageBag, IsToldFromOtherFiles)
{
  std::ofstream(path_) << "no bag";
  const auto film = [&] { filmBag(path_, folder_.path() + "/film/", PictureFormat(), [](int64_t, int64_t) {}); };
  EXPECT_NE(messageOf<InvalidInput>(film).find("cannot be read as a bag"), std::string::npos);
  {
    rosbag::Bag bag(path_, rosbag::bagmode::Write);
    bag.write("/chatter", ros::Time(1.0), std_msgs::String());
  }
  EXPECT_NE(messageOf<InvalidInput>(film).find("shows no robot"), std::string::npos);
}
}  // namespace
}  // namespace devo_evo
