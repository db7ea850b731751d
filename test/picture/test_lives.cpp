#include "devo_evo/picture/life_scene.h"
#include "devo_evo/picture/lineage.h"
#include "devo_evo/picture/pictures.h"
#include "devo_evo/render/shown_robot.h"

#include "archive/test_tools.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <fstream>

namespace devo_evo
{
namespace
{
using test::messageOf;

/// The robot of the reference that rolls from birth.
ShownRobot roller(double lifetime)
{
  SoftBodySettings body;
  body.lifetime = lifetime;
  return readRobotFile(TEST_DATA_DIR "/genomes.jsonl", "roller-11", BodySettings(body));
}

ArchivedIndividual individualOf(int64_t generation, double fitness)
{
  ArchivedIndividual archived;
  archived.individual.trial = 1;
  archived.individual.generation = generation;
  archived.individual.evaluation = Evaluation();
  archived.individual.evaluation->valid = true;
  archived.individual.evaluation->fitness = fitness;
  archived.individual.evaluation->turns = 0.0;
  archived.individual.evaluation->airborne_fraction = 0.0;
  return archived;
}

TEST(LifeScene, EndsWhereTheEvaluationEnds)
{
  const ShownRobot robot = roller(1.0);
  LifeScene life(robot, ViewOptions());
  int pictures = 1;
  while (life.next())
  {
    ++pictures;
  }
  EXPECT_EQ(pictures, 26) << "25 a second, the first at birth";
  EXPECT_NEAR(life.readings().travelled, evaluate(robot.body.soft, { robot.program }).front().fitness, 1e-12);
  EXPECT_EQ(life.evaluation().state_hash, evaluate(robot.body.soft, { robot.program }).front().state_hash);
  EXPECT_FALSE(life.next());
}

TEST(LifeScene, KeepsTheRobotInThePicture)
{
  LifeScene life(roller(2.0), ViewOptions());
  do
  {
    const Eigen::Vector2d place = life.camera().toPicture(life.frame().center_of_mass, 1280, 720);
    EXPECT_NEAR(place.x(), 640, 200) << life.frame().time_since_birth;
    EXPECT_NEAR(place.y(), 360, 120) << life.frame().time_since_birth;
  } while (life.next());
}

TEST(FloorMarks, CountBodyLengthsFromTheBirthplace)
{
  Camera camera;
  camera.target = { 0.0, 0.43, 0.0 };
  const std::vector<FloorMark> marks = floorMarks({ 0.0, 0.03, 0.0 }, camera, 0.04, 0.04);
  ASSERT_FALSE(marks.empty());
  for (const FloorMark& mark : marks)
  {
    EXPECT_NEAR(mark.place.y(), 0.03 + 0.04 * mark.body_lengths, 1e-12);
  }
  EXPECT_EQ(marks[marks.size() / 2].body_lengths, 10);
}

TEST(FollowingPoint, DoesNotFallBehindOneThatMovesEvenly)
{
  FollowingPoint following(0.04, 0.3);
  Eigen::Vector3d followed = Eigen::Vector3d::Zero();
  for (int i = 0; i <= 200; ++i)
  {
    followed = following.follow({ 0.0, 0.01 * i, 0.0 });
  }
  EXPECT_NEAR(followed.y(), 2.0, 1e-4);
}

TEST(EvenlySpaced, AlwaysHasFounderAndChampion)
{
  EXPECT_EQ(evenlySpaced(101, 5), (std::vector<size_t>{ 0, 25, 50, 75, 100 }));
  EXPECT_EQ(evenlySpaced(3, 0), (std::vector<size_t>{ 0, 1, 2 }));
  EXPECT_EQ(evenlySpaced(3, 10), (std::vector<size_t>{ 0, 1, 2 }));
  EXPECT_EQ(evenlySpaced(1, 5), (std::vector<size_t>{ 0 }));
  EXPECT_THROW(evenlySpaced(3, 1), InvalidInput);
  EXPECT_THROW(evenlySpaced(3, -2), InvalidInput);
}

TEST(StepsOfProgress, AreWhoFirstGetsThatFar)
{
  Lineage lineage;
  const double fitness[] = { 0.0, 1.0, 4.0, 4.5, 9.0, 10.0 };
  for (const double value : fitness)
  {
    lineage.individuals.push_back(individualOf(static_cast<int64_t>(lineage.individuals.size()), value));
  }
  // Steps at 10/3 and 20/3.
  EXPECT_EQ(stepsOfProgress(lineage, 4), (std::vector<size_t>{ 0, 2, 4, 5 }));
  EXPECT_EQ(stepsOfProgress(lineage, 2), (std::vector<size_t>{ 0, 5 }));
  EXPECT_THROW(stepsOfProgress(lineage, 1), InvalidInput);
}

TEST(BehaviourText, TellsWalkersFromRollers)
{
  const std::shared_ptr<const Body> body = makeBody(BodySettings());
  Evaluation evaluation = *individualOf(0, 6.0).individual.evaluation;
  EXPECT_EQ(behaviourText(evaluation, *body), "walks");
  evaluation.fell_over_since_birth_s = 9.06;
  EXPECT_EQ(behaviourText(evaluation, *body), "walks and falls over 9.1 s after birth");
  evaluation.turns = 8.7;
  EXPECT_EQ(behaviourText(evaluation, *body), "rolls 9 times, first on its back 9.1 s after birth");
  EXPECT_EQ(behaviourText(*individualOf(0, 0.2).individual.evaluation, *body), "shuffles");
  EXPECT_EQ(behaviourText(Evaluation(), *body), "its simulation diverges");
}

TEST(PictureOfLife, ShowsTheRobotInColourInTheMiddle)
{
  const Image image = pictureOfLife(roller(0.5), 0.2, PictureFormat());
  int coloured = 0;
  for (int y = 200; y < 520; ++y)
  {
    for (int x = 440; x < 840; ++x)
    {
      const auto [red, green, blue] = image.rgb(x, y);
      coloured += std::max({ red, green, blue }) - std::min({ red, green, blue }) > 80 ? 1 : 0;
    }
  }
  EXPECT_GT(coloured, 10000);
  EXPECT_LT(coloured, 80000);
}

TEST(PictureOfLife, RefusesTimesOutsideOfLife)
{
  EXPECT_NE(messageOf<InvalidInput>([] { pictureOfLife(roller(0.5), 0.6, PictureFormat()); }).find("0 to 0.5 s"),
            std::string::npos);
  EXPECT_THROW(pictureOfLife(roller(0.5), -0.1, PictureFormat()), InvalidInput);
  EXPECT_THROW(pictureOfLife(roller(0.5), NAN, PictureFormat()), InvalidInput);
}

TEST(StripOfLife, HasPosesAboveAndTracesBelow)
{
  const int width = 800;
  const Image strip = stripOfLife(roller(1.0), 4, std::nullopt, width, Colouring::RESTING_LENGTH);
  ASSERT_EQ(strip.width(), width);
  std::vector<int> coloured(4, 0);  // in the column of each pose
  int below = 0;                    // orange arrows
  for (int y = 0; y < strip.height(); ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const auto [red, green, blue] = strip.rgb(x, y);
      const bool vivid = std::max({ red, green, blue }) - std::min({ red, green, blue }) > 80;
      const bool in_poses = y > 60 && y < 250;
      coloured[static_cast<size_t>(4 * x / width)] += vivid && in_poses ? 1 : 0;
      below += vivid && red > 180 && y > strip.height() - 100 ? 1 : 0;
    }
  }
  for (const int pixels : coloured)
  {
    EXPECT_GT(pixels, 1000);
  }
  EXPECT_GT(below, 50);
}

TEST(StripOfLife, RefusesWhatMakesNoSense)
{
  EXPECT_THROW(stripOfLife(roller(1.0), 1, std::nullopt, 800, Colouring::PHASE), InvalidInput);
  EXPECT_THROW(stripOfLife(roller(1.0), 5, 48, 800, Colouring::PHASE), InvalidInput);
}

TEST(PictureFormat, NamesWhatIsOutOfRange)
{
  PictureFormat format;
  format.speed = 0.0;
  EXPECT_NE(messageOf<InvalidInput>([&] { format.validate(); }).find("speed"), std::string::npos);
  format = PictureFormat();
  format.pictures_per_s = 0;
  EXPECT_NE(messageOf<InvalidInput>([&] { format.validate(); }).find("rate"), std::string::npos);
  format = PictureFormat();
  format.width = 100000;
  EXPECT_NE(messageOf<InvalidInput>([&] { format.validate(); }).find("100000"), std::string::npos);
}
}  // namespace
}  // namespace devo_evo
