// What players show, and how they are told what to show. Runs beside players "left" and "right" (player.test).

#include "archive/test_tools.h"
#include "devo_evo/experiment/experiment.h"
#include "devo_evo/farm/local_farm.h"
#include "devo_evo/render/appearance.h"
#include "devo_evo/render/colouring.h"
#include "devo_evo/render/robot_mesh.h"
#include "devo_evo/render/shown_robot.h"
#include "ros/conversions.h"
#include "ros/message_fields.h"

#include <devo_evo/PlayerState.h>
#include <devo_evo/Show.h>

#include <gtest/gtest.h>
#include <ros/package.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/transform_listener.h>
#include <visualization_msgs/MarkerArray.h>

#include <functional>
#include <map>
#include <optional>

namespace devo_evo
{
namespace
{
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr double ROUNDING = 0x1p-18 + 1e-12;  // of positions in markers [m]
constexpr double BODY_LENGTH = 0.04;
constexpr size_t CORNERS[] = { 0, 1, 2, 0, 2, 3 };  // of a face, in its two triangles

bool eventually(const std::function<bool()>& condition)
{
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(30.0);
  while (!condition())
  {
    if (ros::WallTime::now() > end)
    {
      return false;
    }
    ros::WallDuration(0.005).sleep();
    ros::spinOnce();
  }
  return true;
}

Eigen::Vector3d vectorOf(const geometry_msgs::Point& point)
{
  return { point.x, point.y, point.z };
}

/// What one player publishes.
class Screen
{
public:
  explicit Screen(const std::string& player)
    : player_(player)
    , robot_(node_.subscribe(player + "/robot", 1000, &Screen::tookRobot, this))
    , floor_(node_.subscribe(player + "/floor", 10, &Screen::tookFloor, this))
    , state_(node_.subscribe(player + "/state", 1000, &Screen::tookState, this))
  {
  }

  /// A picture and the state that belong together, shown from now on and fit a condition.
  bool shows(const std::function<bool(const PlayerState&)>& condition)
  {
    states_.clear();
    pictures_.clear();
    return eventually(
        [&]
        {
          for (const auto& [stamp, state] : states_)
          {
            if (pictures_.count(stamp) == 1 && condition(state))
            {
              state_shown = state;
              picture = pictures_[stamp];
              return true;
            }
          }
          return false;
        });
  }

  bool shows(const std::string& individual)
  {
    return shows([&](const PlayerState& state) { return state.individual == individual; });
  }

  Marker marker(const std::string& name_space) const
  {
    for (const Marker& marker : picture.markers)
    {
      if (marker.ns == name_space)
      {
        return marker;
      }
    }
    ADD_FAILURE() << "there is no marker of " << name_space;
    return Marker();
  }

  Show::Response order(const Show::Request& request)
  {
    Show call;
    call.request = request;
    EXPECT_TRUE(ros::service::call(player_ + "/show", call));
    return call.response;
  }

  void call(const std::string& service)
  {
    std_srvs::Trigger trigger;
    EXPECT_TRUE(ros::service::call(player_ + "/" + service, trigger));
    EXPECT_TRUE(trigger.response.success);
  }

  MarkerArray picture;
  PlayerState state_shown;
  MarkerArray floor;

private:
  void tookRobot(const MarkerArray& picture) { pictures_[picture.markers.front().header.stamp] = picture; }
  void tookFloor(const MarkerArray& markers) { floor = markers; }
  void tookState(const PlayerState& state) { states_[state.header.stamp] = state; }

  const std::string player_;
  ros::NodeHandle node_;
  std::map<ros::Time, MarkerArray> pictures_;
  std::map<ros::Time, PlayerState> states_;
  ros::Subscriber robot_;
  ros::Subscriber floor_;
  ros::Subscriber state_;
};

class Quiet : public ExperimentObserver
{
  void generationCommitted(const GenerationReport&) override {}
};

/// A small experiment of short lives with as many generations as it is told.
class Evolution
{
public:
  Evolution()
  {
    settings.output = folder_.path();
    settings.body.soft.lifetime = 0.3;
    settings.evolution.population = 4;
    settings.trials = 2;
  }

  void evolveTo(int64_t generation)
  {
    settings.generations = generation;
    const auto archive = openArchiveForWriting(settings, test::someProvenance());
    const auto farm = makeLocalFarm(makeBody(settings.body), 1);
    Quiet observer;
    Experiment(settings, *archive, *farm, observer).run();
  }

  /// Goes on until a trial has another champion. @return the name of it.
  std::string evolveToNewChampion(int64_t trial)
  {
    const std::string before = champion(trial);
    while (champion(trial) == before)
    {
      evolveTo(settings.generations + 1);
    }
    return champion(trial);
  }

  std::string champion(int64_t trial) const
  {
    return individualName(trial, openArchiveForReading(settings.output)->championOf(trial));
  }

  ShownRobot robot(const std::string& choice) const
  {
    return *findRobot(*openArchiveForReading(settings.output), parseRobotChoice(choice));
  }

  ExperimentSettings settings;

private:
  const test::TemporaryFolder folder_;
};

/// The state of the simulation at exactly this time.
RobotFrame frameAt(const ShownRobot& robot, double time)
{
  LifePlayback life(robot.body, robot.program);
  life.advanceTo(time - 0.5 * robot.body.soft.timeStep());
  EXPECT_EQ(life.time(), time);
  return life.frame();
}

void expectRobot(const Screen& screen, const ShownRobot& robot, Colouring colouring, double offset_x)
{
  const RobotFrame frame = frameAt(robot, screen.state_shown.time);
  const Eigen::Vector3d offset(offset_x, 0.0, 0.0);
  const Marker voxels = screen.marker("parts");
  ASSERT_EQ(voxels.points.size(), 48u);
  ASSERT_EQ(voxels.colors.size(), 48u);
  for (size_t voxel = 0; voxel < 48; ++voxel)
  {
    EXPECT_LT((vectorOf(voxels.points[voxel]) - frame.parts[voxel].position - offset).cwiseAbs().maxCoeff(), ROUNDING);
    const Colour colour = makeAppearance(robot.body)->colourOf(frame, voxel, colouring);
    EXPECT_EQ(voxels.colors[voxel].r, colour.red);
    EXPECT_EQ(voxels.colors[voxel].g, colour.green);
    EXPECT_EQ(voxels.colors[voxel].b, colour.blue);
  }
  const Marker body = screen.marker("body");
  const RobotMesh mesh(robot.body.soft);
  const std::vector<Eigen::Vector3d> vertices = mesh.vertices(frame);
  ASSERT_EQ(body.points.size(), 6 * mesh.faces().size());
  for (size_t face = 0; face < mesh.faces().size(); ++face)
  {
    const auto& corners = mesh.faces()[face].corners;
    for (size_t i = 0; i < 6; ++i)
    {
      const Eigen::Vector3d expected = vertices[static_cast<size_t>(corners[CORNERS[i]])] + offset;
      EXPECT_LT((vectorOf(body.points[6 * face + i]) - expected).cwiseAbs().maxCoeff(), ROUNDING);
    }
  }
}

/// Volume within the triangles of a marker, by the divergence theorem [m^3].
double volumeOf(const Marker& triangles)
{
  double volume = 0.0;
  for (size_t i = 0; i + 2 < triangles.points.size(); i += 3)
  {
    volume +=
        vectorOf(triangles.points[i]).dot(vectorOf(triangles.points[i + 1]).cross(vectorOf(triangles.points[i + 2]))) /
        6.0;
  }
  return volume;
}

class PlayerTest : public testing::Test
{
protected:
  static ShownRobot goldenRobot()
  {
    SoftBodySettings body;
    body.lifetime = 1.0;
    return readRobotFile(ros::package::getPath("devo_evo") + "/test/data/genomes.jsonl", "golden-005",
                         BodySettings(body));
  }

  void TearDown() override
  {
    Show::Request golden;
    golden.genome_file = ros::package::getPath("devo_evo") + "/test/data/genomes.jsonl";
    golden.individual = "golden-005";
    golden.colour = "resting_length";
    golden.speed = 1.0;
    EXPECT_TRUE(left_.order(golden).success);
  }

  Show::Request requestFor(const Evolution& evolution, const std::string& individual)
  {
    Show::Request request;
    request.output = evolution.settings.output;
    request.individual = individual;
    return request;
  }

  ros::NodeHandle node_;
  Screen left_{ "left" };
};

TEST_F(PlayerTest, ShowsEveryVoxelWhereTheSimulationHasItAtThatTime)
{
  for (const double time : { 0.0, 0.4, 0.8 })
  {
    ASSERT_TRUE(
        left_.shows([&](const PlayerState& state) { return state.individual == "golden-005" && state.time > time; }));
    expectRobot(left_, goldenRobot(), Colouring::RESTING_LENGTH, 0.0);
  }
}

TEST_F(PlayerTest, BlocksFillAboutTheSpaceOfTheirVoxels)
{
  ASSERT_TRUE(left_.shows("golden-005"));
  double volume = 0.0;
  for (const ShownPart& voxel : frameAt(goldenRobot(), left_.state_shown.time).parts)
  {
    volume += voxel.present_length * voxel.present_length * voxel.present_length;
  }
  EXPECT_NEAR(volumeOf(left_.marker("body")) / volume, 1.0, 0.35);  // soft bodies are squeezed
}

TEST_F(PlayerTest, LivesInRealTimeAgainAndAgain)
{
  ASSERT_TRUE(left_.shows([](const PlayerState& state) { return state.time < 0.1; }));
  const PlayerState young = left_.state_shown;
  ASSERT_TRUE(left_.shows([](const PlayerState& state) { return state.time > 0.8; }));
  const double elapsed = (left_.state_shown.header.stamp - young.header.stamp).toSec();
  EXPECT_NEAR(left_.state_shown.time - young.time, elapsed, 0.3);
  ASSERT_TRUE(left_.shows([](const PlayerState& state) { return state.time > 0.9999; }));  // its very end
  EXPECT_TRUE(left_.shows([](const PlayerState& state) { return state.time < 0.1; }));
}

TEST_F(PlayerTest, PublishesFramesOfTheRobotAndForCameras)
{
  tf2_ros::Buffer buffer;
  const tf2_ros::TransformListener listener(buffer);
  ASSERT_TRUE(eventually([&] { return buffer.canTransform("world", "left/robot", ros::Time(0)); }));
  ASSERT_TRUE(left_.shows([&](const PlayerState& state)
                          { return buffer.canTransform("world", "left/robot", state.header.stamp); }));
  const RobotFrame frame = frameAt(goldenRobot(), left_.state_shown.time);
  const auto robot = buffer.lookupTransform("world", "left/robot", left_.state_shown.header.stamp).transform;
  const auto follow = buffer.lookupTransform("world", "left/follow", left_.state_shown.header.stamp).transform;
  EXPECT_NEAR(robot.translation.x, frame.center_of_mass.x(), 1e-9);
  EXPECT_NEAR(robot.translation.y, frame.center_of_mass.y(), 1e-9);
  EXPECT_NEAR(robot.translation.z, frame.center_of_mass.z(), 1e-9);
  EXPECT_NEAR(std::abs(robot.rotation.w), std::abs(frame.orientation.w()), 1e-9);
  EXPECT_NEAR(follow.translation.x, frame.center_of_mass.x(), 1e-9);
  EXPECT_NEAR(follow.translation.y, frame.center_of_mass.y(), 1e-9);
  EXPECT_EQ(follow.translation.z, 0.0);
  EXPECT_EQ(follow.rotation.w, 1.0);
}

TEST_F(PlayerTest, CaptionPathArrowAndFloorAreThere)
{
  ASSERT_TRUE(
      left_.shows([](const PlayerState& state) { return state.individual == "golden-005" && state.time > 0.5; }));
  const ShownRobot robot = goldenRobot();
  const LifeSurvey life = surveyLife(robot);
  EXPECT_EQ(left_.marker("caption").text, captionText(robot, life.evaluation, left_.state_shown.time));
  EXPECT_EQ(left_.state_shown.fitness, life.evaluation.fitness);
  EXPECT_EQ(left_.state_shown.record, PlayerState::NOT_RECORDED);

  const RobotFrame frame = frameAt(robot, left_.state_shown.time);
  const Marker path = left_.marker("path"), arrow = left_.marker("velocity");
  EXPECT_GT(path.points.size(), 5u);
  EXPECT_LT((vectorOf(path.points.back()) - frame.center_of_mass).norm(), 2 * ROUNDING);
  ASSERT_EQ(arrow.points.size(), 2u);
  EXPECT_NEAR(arrow.points[0].y, frame.center_of_mass.y(), ROUNDING);
  EXPECT_NEAR(arrow.points[1].y - arrow.points[0].y, BODY_LENGTH * left_.state_shown.velocity, 2 * ROUNDING);
  EXPECT_NEAR(left_.state_shown.displacement, (frame.center_of_mass.y() - life.birthplace.y()) / BODY_LENGTH, 1e-9);

  ASSERT_TRUE(eventually([&] { return left_.floor.markers.size() > 4; }));
  EXPECT_EQ(left_.floor.markers[0].action, Marker::DELETEALL);
  EXPECT_EQ(left_.floor.markers[1].ns, "floor");
  const Marker& lines = left_.floor.markers[2];
  EXPECT_NEAR(lines.points[2].x - lines.points[0].x, BODY_LENGTH, 4 * ROUNDING);
}

TEST_F(PlayerTest, AnIndividualOfAnArchiveIsWhatTheArchiveSays)
{
  Evolution evolution;
  evolution.evolveTo(2);
  const Show::Response response = left_.order(requestFor(evolution, "2/5"));
  ASSERT_TRUE(response.success) << response.message;
  ASSERT_TRUE(left_.shows("2/5"));
  const ShownRobot robot = evolution.robot("2/5");
  EXPECT_EQ(left_.state_shown.record, PlayerState::AGREES);
  EXPECT_EQ(left_.state_shown.fitness, robot.recorded->fitness);
  EXPECT_EQ(left_.state_shown.trial, 2);
  EXPECT_EQ(left_.state_shown.id, 5);
  EXPECT_EQ(left_.state_shown.born, robot.descent->generation);
  EXPECT_EQ(left_.state_shown.treatment, "evo_devo");
  expectRobot(left_, robot, Colouring::RESTING_LENGTH, 0.0);
}

TEST_F(PlayerTest, TheChampionOfATrialIsFollowedAsItImproves)
{
  Evolution evolution;
  evolution.evolveTo(1);
  ASSERT_TRUE(left_.order(requestFor(evolution, "2")).success);
  ASSERT_TRUE(left_.shows(evolution.champion(2)));
  const std::string next = evolution.evolveToNewChampion(2);
  ASSERT_TRUE(left_.shows(next));
  EXPECT_EQ(left_.state_shown.record, PlayerState::AGREES);
}

TEST_F(PlayerTest, AnArchiveIsShownWhileItIsWrittenTo)
{
  Evolution evolution;
  evolution.evolveTo(1);
  const auto writer = openArchiveForWriting(evolution.settings, test::someProvenance());
  ASSERT_TRUE(left_.order(requestFor(evolution, "best")).success);
  EXPECT_TRUE(left_.shows([](const PlayerState& state) { return state.trial > 0; }));
}

TEST_F(PlayerTest, WhatCannotBeShownIsSaidAndTheOldRobotStays)
{
  Evolution evolution;
  evolution.evolveTo(1);
  const auto refusal = [this](const std::function<void(Show::Request&)>& fill)
  {
    Show::Request request;
    fill(request);
    const Show::Response response = left_.order(request);
    EXPECT_FALSE(response.success);
    return response.message;
  };
  EXPECT_NE(refusal([&](auto& r) { r = requestFor(evolution, "1/4711"); }).find("4711"), std::string::npos);
  EXPECT_NE(refusal([&](auto& r) { r = requestFor(evolution, "7/0"); }), "");
  EXPECT_NE(refusal([&](auto& r) { r = requestFor(evolution, "worst"); }).find("it must be best"), std::string::npos);
  EXPECT_NE(refusal([](auto& r) { r.output = "/nonexistent"; }).find("/nonexistent"), std::string::npos);
  EXPECT_NE(refusal([](auto& r) { r.output = "results"; }).find("absolute path"), std::string::npos);
  EXPECT_NE(refusal([](auto& r) { r.genome_file = "/nonexistent.jsonl"; }).find("cannot be read"), std::string::npos);
  EXPECT_NE(refusal([](auto& r) { r.colour = "rainbow"; }).find("present_length"), std::string::npos);
  EXPECT_NE(refusal([](auto& r) { r.speed = -1.0; }).find("0.001"), std::string::npos);
  EXPECT_NE(refusal([](auto& r) { r.speed = std::numeric_limits<double>::quiet_NaN(); }), "");
  EXPECT_TRUE(left_.shows("golden-005"));
}

TEST_F(PlayerTest, AnEmptyArchiveIsSaidToHaveNothingYet)
{
  Evolution evolution;
  openArchiveForWriting(evolution.settings, test::someProvenance());
  const Show::Response response = left_.order(requestFor(evolution, "best"));
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find("there is no valid robot"), std::string::npos);
}

TEST_F(PlayerTest, ColourAndSpeedCanBeChangedWhileItPlays)
{
  Show::Request request;
  request.colour = "remaining_development";
  request.speed = 0.25;
  ASSERT_TRUE(left_.order(request).success);
  ASSERT_TRUE(left_.shows([](const PlayerState& state)
                          { return state.speed == 0.25 && state.colour == "remaining_development"; }));
  expectRobot(left_, goldenRobot(), Colouring::REMAINING_DEVELOPMENT, 0.0);
}

TEST_F(PlayerTest, TimeStandsStillWhilePaused)
{
  left_.call("pause");
  ASSERT_TRUE(left_.shows([](const PlayerState& state) { return state.paused; }));
  const double time = left_.state_shown.time;
  ASSERT_TRUE(left_.shows([](const PlayerState& state) { return state.paused; }));  // it is still shown
  EXPECT_EQ(left_.state_shown.time, time);
  left_.call("resume");
  EXPECT_TRUE(left_.shows([&](const PlayerState& state) { return !state.paused && state.time != time; }));
}

/// Plays the evolver that the player "right" follows.
class FollowerTest : public PlayerTest
{
protected:
  FollowerTest()
    : settings_(node_.advertise<EvaluationSettings>("settings", 1, true))
    , best_(node_.advertise<EvolvedRobot>("best", 10, true))
  {
    evolution_.evolveTo(1);
    settings_.publish(toMsg(evolution_.settings.body));
  }

  EvolvedRobot message(const std::string& choice) const
  {
    const auto archive = openArchiveForReading(evolution_.settings.output);
    const RobotChoice robot = parseRobotChoice(choice);
    return toMsg(archive->readIndividual(*robot.trial, *robot.id), archive->settings());
  }

  Evolution evolution_;
  Screen right_{ "right" };
  ros::Publisher settings_;
  ros::Publisher best_;
};

TEST_F(FollowerTest, TheBestRobotThatAnEvolverTellsOfIsFollowed)
{
  best_.publish(message("1/2"));
  ASSERT_TRUE(right_.shows("1/2"));
  EXPECT_EQ(right_.state_shown.record, PlayerState::AGREES);
  best_.publish(message("2/3"));
  ASSERT_TRUE(right_.shows("2/3"));
}

TEST_F(FollowerTest, TwoPlayersStandSideBySide)
{
  best_.publish(message("1/1"));
  ASSERT_TRUE(right_.shows("1/1"));
  expectRobot(right_, evolution_.robot("1/1"), Colouring::PHASE, 7.0 * BODY_LENGTH);
  ASSERT_TRUE(left_.shows("golden-005"));
  expectRobot(left_, goldenRobot(), Colouring::RESTING_LENGTH, 0.0);
}

TEST_F(FollowerTest, ALifeThatIsNotAsRecordedIsSaidNotToBe)
{
  EvolvedRobot altered = message("1/3");
  altered.evaluation.state_hash ^= 1;
  best_.publish(altered);
  ASSERT_TRUE(right_.shows([](const PlayerState& state)
                           { return state.individual == "1/3" && state.record == PlayerState::DIFFERS; }));
  EXPECT_NE(right_.marker("caption").text.find("NOT AS RECORDED"), std::string::npos);
}

TEST_F(FollowerTest, MessagesThatMakeNoSenseAreIgnored)
{
  best_.publish(message("1/1"));
  ASSERT_TRUE(right_.shows("1/1"));
  EvolvedRobot nonsense = message("1/2");
  test::valuesOf(nonsense.genome, "phase_final").resize(3);
  best_.publish(nonsense);
  nonsense = message("1/2");
  test::valuesOf(nonsense.genome, "size_gene_final")[7] = std::numeric_limits<double>::infinity();
  best_.publish(nonsense);
  best_.publish(message("2/2"));
  EXPECT_TRUE(right_.shows("2/2"));
}
}  // namespace
}  // namespace devo_evo

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "player_rostest");
  return RUN_ALL_TESTS();
}
