// The panel of rviz, its controls clicked, beside a real player (panel.test). No display is needed: Qt draws off
// screen.

#include "rviz_plugin/lineage_panel.h"

#include "verification/real_experiment.h"

#include <devo_evo/Show.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QtTest/QTest>

#include <gtest/gtest.h>
#include <ros/package.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <memory>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace devo_evo
{
namespace
{
using test::evolveReally;
using test::TemporaryFolder;

constexpr int LONGEST_WAIT_MS = 60000;
constexpr int LONGEST_GAP_MS = 1000;  // a busy machine has the thread wait; a call to a dead server would take seconds

/// Serves the GUI until the condition holds. @return whether it did.
bool eventually(const std::function<bool()>& condition)
{
  return QTest::qWaitFor(condition, LONGEST_WAIT_MS);
}

/// Measures how long the GUI's thread does not get round to its events.
class Heartbeat
{
public:
  Heartbeat()
  {
    QObject::connect(&timer_, &QTimer::timeout, [this] { longest_ms_ = std::max(longest_ms_, since_.restart()); });
    since_.start();
    timer_.start(5);
  }

  qint64 longestGapMs() const { return longest_ms_; }

private:
  QTimer timer_;
  QElapsedTimer since_;
  qint64 longest_ms_ = 0;
};

/// The panel as rviz makes it, and its controls by their names.
class ShownPanel
{
public:
  explicit ShownPanel(const rviz::Config& config = rviz::Config())
  {
    panel_->initialize(nullptr);
    panel_->load(config);
    panel_->resize(360, 700);
    panel_->show();
  }

  template <class Widget>
  Widget& find(const char* name) const
  {
    return dynamic_cast<Widget&>(*panel_->findChild<QWidget*>(name));
  }

  LineagePlot& plot() const { return find<LineagePlot>("plot"); }
  QSlider& slider() const { return find<QSlider>("ancestor"); }
  QPushButton& button(const char* name) const { return find<QPushButton>(name); }
  std::string text(const char* label) const { return find<QLabel>(label).text().toStdString(); }
  bool says(const char* label, const std::string& text) const
  {
    return this->text(label).find(text) != std::string::npos;
  }

  void press(const char* name) const { QTest::mouseClick(&button(name), Qt::LeftButton); }

  void enter(const char* field, const std::string& text) const
  {
    auto& line = find<QLineEdit>(field);
    line.setFocus();
    line.selectAll();
    QTest::keyClick(&line, Qt::Key_Backspace);
    QTest::keyClicks(&line, QString::fromStdString(text));
    QTest::keyClick(&line, Qt::Key_Return);
  }

  /// Of the plot at the place of an ancestor.
  void clickPlot(size_t position) const
  {
    QTest::mouseClick(&plot(), Qt::LeftButton, {}, QPoint(static_cast<int>(std::lround(plot().xOf(position))), 50));
  }

  rviz::Config saved() const
  {
    rviz::Config config;
    panel_->save(config);
    return config;
  }

  QImage picture() const { return panel_->grab().toImage(); }
  void close() { panel_.reset(); }

private:
  std::unique_ptr<LineagePanel> panel_ = std::make_unique<LineagePanel>();
};

/// How many pixels have this colour, but for smooth edges.
int pixelsLike(const QImage& picture, const std::array<double, 3>& colour)
{
  const QColor wanted = QColor::fromRgbF(colour[0], colour[1], colour[2]);
  int count = 0;
  for (int y = 0; y < picture.height(); ++y)
  {
    for (int x = 0; x < picture.width(); ++x)
    {
      const QColor pixel = picture.pixelColor(x, y);
      const int difference = std::abs(pixel.red() - wanted.red()) + std::abs(pixel.green() - wanted.green()) +
                             std::abs(pixel.blue() - wanted.blue());
      count += difference < 12 ? 1 : 0;
    }
  }
  return count;
}

class Panel : public testing::Test
{
protected:
  Panel()
  {
    settings_ = test::shortLives(folder_.path() + "/run");
    settings_.generations = 30;
    evolveReally(settings_);
    ros::param::set("evolver/output", settings_.output);
    state_subscriber_ = node_.subscribe("player/state", 100, &Panel::tookState, this);
    spinner_.start();
    order(
        [](Show::Request& request)
        {
          request.genome_file = ros::package::getPath("devo_evo") + "/test/data/genomes.jsonl";
          request.colour = "resting_length";
          request.speed = 1.0;
        });
    std_srvs::Trigger trigger;
    EXPECT_TRUE(ros::service::waitForService("player/resume", LONGEST_WAIT_MS));
    EXPECT_TRUE(ros::service::call("player/resume", trigger));
  }

  ~Panel() override { ros::param::del("evolver"); }

  static void order(const std::function<void(Show::Request&)>& fill)
  {
    Show show;
    fill(show.request);
    EXPECT_TRUE(ros::service::waitForService("player/show", LONGEST_WAIT_MS));
    EXPECT_TRUE(ros::service::call("player/show", show));
    EXPECT_TRUE(show.response.success) << show.response.message;
  }

  std::vector<ArchivedIndividual> lineage(std::optional<int64_t> trial = std::nullopt) const
  {
    return readLineageView(settings_.output, trial, LineageView()).individuals;
  }

  static std::string nameOf(const ArchivedIndividual& ancestor)
  {
    return individualName(ancestor.individual.trial, ancestor.individual.id);
  }

  /// Whether the panel knows this lineage, by its length.
  static bool knows(const ShownPanel& panel, const std::vector<ArchivedIndividual>& lineage)
  {
    return eventually([&] { return panel.slider().maximum() == static_cast<int>(lineage.size()) - 1; });
  }

  bool playerShows(const std::function<bool(const PlayerState&)>& condition)
  {
    return eventually(
        [&]
        {
          std::lock_guard<std::mutex> lock(mutex_);
          return condition(state_);
        });
  }

  bool playerShows(const std::string& individual)
  {
    return playerShows([&](const PlayerState& state) { return state.individual == individual; });
  }

  void tookState(const PlayerState& state)
  {
    std::lock_guard<std::mutex> lock(mutex_);
    state_ = state;
  }

  const TemporaryFolder folder_;
  ExperimentSettings settings_;
  ros::NodeHandle node_;
  std::mutex mutex_;
  PlayerState state_;  ///< guarded by mutex_
  ros::Subscriber state_subscriber_;
  ros::AsyncSpinner spinner_{ 2 };
};

TEST_F(Panel, PlotsTheLineageOfTheRunningExperimentsBestChampion)
{
  const ShownPanel panel;
  const std::vector<ArchivedIndividual> expected = lineage();
  ASSERT_GT(expected.size(), 3u);
  ASSERT_TRUE(knows(panel, expected)) << panel.text("errors");
  EXPECT_TRUE(panel.says("description", nameOf(expected.back()))) << panel.text("description");
  EXPECT_TRUE(eventually([&] { return panel.text("errors").empty(); })) << panel.text("errors");
  EXPECT_EQ(panel.find<QComboBox>("trial").count(), 3) << "the best, and two trials";
  const QImage picture = panel.picture();
  for (const LineageCurve& curve : lineageCurves(*makeSoftBody(SoftBodySettings())))
  {
    EXPECT_GT(pixelsLike(picture, curve.colour), 100) << curve.title;
  }
}

TEST_F(Panel, AClickInThePlotShowsThatAncestor)
{
  const ShownPanel panel;
  const std::vector<ArchivedIndividual> expected = lineage();
  ASSERT_TRUE(knows(panel, expected));
  panel.clickPlot(0);
  EXPECT_EQ(panel.slider().value(), 0);
  EXPECT_TRUE(panel.says("description", nameOf(expected.front())));
  EXPECT_TRUE(playerShows(nameOf(expected.front()))) << panel.text("errors");
  panel.clickPlot(2);
  EXPECT_TRUE(playerShows(nameOf(expected[2])));
  const QImage picture = panel.plot().grab().toImage();
  const int x = static_cast<int>(std::lround(panel.plot().xOf(2)));
  const LineageCurve fitness = lineageCurves(*makeSoftBody(SoftBodySettings()))[0];
  EXPECT_GT(pixelsLike(picture.copy(x - 6, 0, 13, picture.height() / 3), fitness.colour), 30) << "its mark";
}

TEST_F(Panel, TheSliderLeadsAlongTheLineageToTheChampionThatIsFollowed)
{
  const ShownPanel panel;
  ASSERT_TRUE(knows(panel, lineage()));
  panel.slider().setFocus();
  QTest::keyClick(&panel.slider(), Qt::Key_Home);
  ASSERT_TRUE(playerShows(nameOf(lineage().front())));
  QTest::keyClick(&panel.slider(), Qt::Key_Right);
  ASSERT_TRUE(playerShows(nameOf(lineage()[1])));
  QTest::keyClick(&panel.slider(), Qt::Key_End);
  ASSERT_TRUE(playerShows(nameOf(lineage().back())));
  const std::string before = nameOf(lineage().back());
  while (nameOf(lineage().back()) == before)
  {
    ++settings_.generations;
    evolveReally(settings_);
  }
  EXPECT_TRUE(playerShows(nameOf(lineage().back()))) << "the player follows";
  EXPECT_TRUE(eventually([&] { return panel.says("description", nameOf(lineage().back())); })) << "and the panel";
}

TEST_F(Panel, AnAncestorStaysChosenWhenAnotherTrialTakesTheLead)
{
  settings_.output = folder_.path() + "/growing";
  settings_.trials = 1;
  settings_.generations = 30;
  evolveReally(settings_);
  ros::param::set("evolver/output", settings_.output);
  const std::vector<ArchivedIndividual> first = lineage(1);
  const ShownPanel panel;
  ASSERT_TRUE(knows(panel, first));
  panel.clickPlot(1);
  settings_.trials = 2;
  settings_.generations = 110;
  evolveReally(settings_);
  ASSERT_EQ(lineage().front().individual.trial, 2) << "it leads now";
  EXPECT_TRUE(eventually([&] { return panel.find<QComboBox>("trial").count() == 3; })) << "it has been read";
  EXPECT_EQ(panel.slider().value(), 1);
  EXPECT_TRUE(panel.says("description", nameOf(first[1]))) << panel.text("description");
  int saved_trial = 0;
  ASSERT_TRUE(panel.saved().mapGetInt("Trial", &saved_trial));
  EXPECT_EQ(saved_trial, 1) << "an ancestor's id means nothing without its trial";

  QTest::keyClick(&panel.slider(), Qt::Key_End);
  EXPECT_TRUE(knows(panel, lineage())) << "who looks at the champion follows the best trial";
  EXPECT_TRUE(playerShows(nameOf(lineage().back())));
}

TEST_F(Panel, PausesAndChangesSpeedAndColour)
{
  const ShownPanel panel;
  ASSERT_TRUE(knows(panel, lineage()));
  ASSERT_TRUE(eventually([&] { return panel.text("errors").empty(); }));
  panel.press("pause");
  ASSERT_TRUE(playerShows([](const PlayerState& state) { return state.paused; }));
  ASSERT_TRUE(eventually([&] { return panel.button("pause").text() == "Play"; }));
  panel.press("pause");
  ASSERT_TRUE(playerShows([](const PlayerState& state) { return !state.paused; }));

  auto& speed = panel.find<QDoubleSpinBox>("speed");
  speed.setFocus();
  speed.selectAll();
  QTest::keyClicks(&speed, "0.25");
  QTest::keyClick(&speed, Qt::Key_Return);
  ASSERT_TRUE(playerShows([](const PlayerState& state) { return state.speed == 0.25; }));
  auto& colour = panel.find<QComboBox>("colour");
  colour.setFocus();
  QTest::keyClick(&colour, Qt::Key_Down);
  ASSERT_TRUE(playerShows([](const PlayerState& state) { return state.colour == "remaining_development"; }));
  EXPECT_EQ(panel.text("errors"), "");
}

TEST_F(Panel, ItsControlsTellWhatOthersOrder)
{
  const ShownPanel panel;
  const std::vector<ArchivedIndividual> expected = lineage();
  ASSERT_TRUE(knows(panel, expected));
  order(
      [&](Show::Request& request)
      {
        request.output = settings_.output;
        request.individual = nameOf(expected[1]);
        request.colour = "phase";
        request.speed = 0.5;
      });
  EXPECT_TRUE(eventually([&] { return panel.slider().value() == 1; }));
  EXPECT_TRUE(eventually([&] { return panel.find<QDoubleSpinBox>("speed").value() == 0.5; }));
  EXPECT_EQ(panel.find<QComboBox>("colour").currentText(), "phase");
}

TEST_F(Panel, AnotherTrialOrExperimentIsShownAtOnce)
{
  const ShownPanel panel;
  ASSERT_TRUE(knows(panel, lineage()));
  auto& trial = panel.find<QComboBox>("trial");
  trial.setFocus();
  QTest::keyClick(&trial, Qt::Key_End);
  EXPECT_TRUE(playerShows(nameOf(lineage(2).back())));

  settings_.output = folder_.path() + "/other";
  settings_.evolution.seed = 77;
  settings_.trials = 1;
  evolveReally(settings_);
  QTest::keyClick(&trial, Qt::Key_Home);
  panel.enter("experiment", settings_.output);
  EXPECT_TRUE(knows(panel, lineage()));
  EXPECT_TRUE(playerShows(nameOf(lineage().back())));
  EXPECT_TRUE(eventually([&] { return trial.count() == 2; }));
}

TEST_F(Panel, ShowsLineagesOfQuadrupedsWithTheirLight)
{
  settings_.output = folder_.path() + "/rigid";
  RigidBodySettings world;
  world.lifetime = 0.2;
  settings_.body = BodySettings(world);
  settings_.generations = 5;
  settings_.trials = 1;
  evolveReally(settings_);
  const ShownPanel panel;
  panel.enter("experiment", settings_.output);
  const std::vector<ArchivedIndividual> expected = lineage();
  ASSERT_TRUE(knows(panel, expected)) << panel.text("errors");
  EXPECT_TRUE(playerShows(nameOf(expected.back()))) << panel.text("errors");
  const std::string fitness = makeBody(settings_.body)->fitnessText(expected.back().individual.evaluation->fitness);
  EXPECT_TRUE(panel.says("description", "fitness " + fitness)) << panel.text("description");
  // So small a fitness stands well above zero on its axis: its mark is in the upper half of the first plot.
  const LineageCurve curve = lineageCurves(*makeBody(settings_.body))[0];
  const QImage picture = panel.plot().grab().toImage();
  EXPECT_GT(pixelsLike(picture.copy(0, 0, picture.width(), picture.height() / 6), curve.colour), 30);
}

TEST_F(Panel, KeepsItsSettingsInTheConfiguration)
{
  const std::vector<ArchivedIndividual> expected = lineage(1);
  rviz::Config config;
  {
    rviz::Config wanted;
    wanted.mapSetValue("Experiment", QString::fromStdString(settings_.output));
    wanted.mapSetValue("Trial", 1);
    wanted.mapSetValue("Ancestor", static_cast<int>(expected[1].individual.id));
    wanted.mapSetValue("Speed", 0.5);
    wanted.mapSetValue("Colour", "phase");
    wanted.mapSetValue("Film", "/tmp/one.mp4");
    const ShownPanel panel(wanted);
    ASSERT_TRUE(playerShows(nameOf(expected[1]))) << panel.text("errors");
    ASSERT_TRUE(playerShows([](const PlayerState& state) { return state.colour == "phase" && state.speed == 0.5; }));
    config = panel.saved();
  }
  order([](Show::Request& request) { request.colour = "resting_length"; });
  const ShownPanel panel(config);
  EXPECT_TRUE(playerShows([](const PlayerState& state) { return state.colour == "phase" && state.speed == 0.5; }));
  EXPECT_TRUE(knows(panel, expected));
  EXPECT_EQ(panel.slider().value(), 1);
  EXPECT_EQ(panel.find<QLineEdit>("film").text(), "/tmp/one.mp4");
  EXPECT_EQ(panel.find<QComboBox>("trial").currentText(), "trial 1");
}

TEST_F(Panel, SaysWhatIsWrongWithAnExperiment)
{
  const ShownPanel panel;
  ASSERT_TRUE(knows(panel, lineage()));
  panel.enter("experiment", "results");
  EXPECT_TRUE(eventually([&] { return panel.says("errors", "it must be the absolute path of a folder"); }));
  EXPECT_FALSE(panel.slider().isEnabled());
  EXPECT_FALSE(panel.button("record").isEnabled());
  panel.enter("experiment", folder_.path());
  EXPECT_TRUE(eventually([&] { return panel.says("errors", folder_.path() + "/experiment.db"); }));
  panel.enter("experiment", "");
  EXPECT_TRUE(knows(panel, lineage()));
  EXPECT_TRUE(eventually([&] { return panel.text("errors").empty(); })) << panel.text("errors");
}

TEST_F(Panel, SaysThatNoExperimentRuns)
{
  ros::param::del("evolver");
  const ShownPanel panel;
  EXPECT_TRUE(eventually([&] { return panel.says("errors", "no experiment runs in /panel"); })) << panel.text("errors");
  ros::param::set("evolver/output", settings_.output);
  EXPECT_TRUE(knows(panel, lineage())) << "it looks again and again";
}

TEST_F(Panel, SaysThatATrialOrAncestorIsUnknown)
{
  rviz::Config config;
  config.mapSetValue("Trial", 99);
  const ShownPanel panel(config);
  EXPECT_TRUE(eventually([&] { return panel.says("errors", "no finished generation of trial 99"); }));
  config = rviz::Config();
  config.mapSetValue("Ancestor", 4711);
  const ShownPanel other(config);
  EXPECT_TRUE(eventually([&] { return other.says("errors", "/4711 is no ancestor"); })) << other.text("errors");
}

TEST_F(Panel, WaitsForTheFirstGenerationOfAnExperiment)
{
  settings_.output = folder_.path() + "/young";
  Provenance provenance = test::someProvenance();
  provenance.engine_fingerprint = 0;  // not known, so that evolution can go on
  openArchiveForWriting(settings_, provenance);
  const ShownPanel panel;
  panel.enter("experiment", settings_.output);
  ASSERT_TRUE(eventually([&] { return panel.says("errors", "no trial has a valid champion yet"); }));
  settings_.generations = 3;
  evolveReally(settings_);
  EXPECT_TRUE(knows(panel, lineage())) << panel.text("errors");
  EXPECT_TRUE(playerShows(nameOf(lineage().back())));
}

TEST_F(Panel, StaysResponsiveWhileEvolutionRuns)
{
  const ShownPanel panel;
  ASSERT_TRUE(knows(panel, lineage()));
  std::atomic<bool> stop{ false };
  std::thread evolution(
      [&]
      {
        while (!stop)
        {
          settings_.generations += 20;
          evolveReally(settings_);
        }
      });
  const Heartbeat heartbeat;
  for (int i = 0; i < 40; ++i)
  {
    panel.clickPlot(static_cast<size_t>(i) % 3);
    QTest::qWait(50);
  }
  stop = true;
  evolution.join();
  EXPECT_LT(heartbeat.longestGapMs(), LONGEST_GAP_MS);
  const int position = panel.slider().value();
  EXPECT_EQ(position, 39 % 3) << "the ancestor that was chosen stays";
}

/// A player that accepts orders and does not answer until it is destroyed.
class SilentPlayer
{
public:
  SilentPlayer()
  {
    service_ = node_.advertiseService<Show::Request, Show::Response>("silent/show",
                                                                     [this](Show::Request&, Show::Response&)
                                                                     {
                                                                       std::unique_lock<std::mutex> lock(mutex_);
                                                                       asked = true;
                                                                       changed_.wait(lock, [this] { return over_; });
                                                                       return true;
                                                                     });
  }

  ~SilentPlayer()
  {
    {
      std::lock_guard<std::mutex> lock(mutex_);
      over_ = true;
    }
    changed_.notify_all();
    service_.shutdown();
  }

  std::atomic<bool> asked{ false };

private:
  ros::NodeHandle node_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool over_ = false;  ///< guarded by mutex_
  ros::ServiceServer service_;
};

rviz::Config ofPlayer(const char* name)
{
  rviz::Config config;
  config.mapSetValue("Player", name);
  return config;
}

TEST_F(Panel, DoesNotWaitForAPlayerThatDoesNotAnswer)
{
  SilentPlayer player;
  const ShownPanel panel(ofPlayer("silent"));
  ASSERT_TRUE(knows(panel, lineage()));
  const Heartbeat heartbeat;
  panel.clickPlot(0);
  EXPECT_TRUE(eventually([&] { return panel.says("errors", "the player did not answer on /panel/silent/show"); }))
      << panel.text("errors");
  EXPECT_LT(heartbeat.longestGapMs(), LONGEST_GAP_MS);
}

TEST_F(Panel, ClosesWhileAPlayerDoesNotAnswer)
{
  SilentPlayer player;
  ShownPanel panel(ofPlayer("silent"));
  ASSERT_TRUE(knows(panel, lineage()));
  panel.clickPlot(0);
  ASSERT_TRUE(eventually([&] { return player.asked.load(); }));
  QElapsedTimer closing;
  closing.start();
  panel.close();
  EXPECT_LT(closing.elapsed(), 4000);
}

TEST_F(Panel, ClosesWhileAnExperimentIsBeingTyped)
{
  ShownPanel panel;
  ASSERT_TRUE(knows(panel, lineage()));
  auto& field = panel.find<QLineEdit>("experiment");
  field.setFocus();
  QTest::keyClicks(&field, "/half/a/na");
  panel.close();
}

TEST_F(Panel, SaysThatThereIsNoPlayer)
{
  const ShownPanel panel(ofPlayer("nobody"));
  ASSERT_TRUE(knows(panel, lineage()));
  EXPECT_TRUE(panel.says("errors", "waiting for the player /panel/nobody"));
  panel.clickPlot(0);
  EXPECT_TRUE(eventually([&] { return panel.says("errors", "no player offers /panel/nobody/show"); }));
}

TEST_F(Panel, RecordsAFilmOfTheChosenRobot)
{
  const ShownPanel panel;
  ASSERT_TRUE(knows(panel, lineage()));
  const std::string film = folder_.path() + "/film.mp4";
  panel.enter("film", film);
  panel.press("record");
  EXPECT_EQ(panel.button("record").text(), "Cancel");
  ASSERT_TRUE(eventually([&] { return panel.says("film_note", "the film is in " + film); }))
      << panel.text("film_error");
  EXPECT_GT(std::filesystem::file_size(film), 1000u);
  EXPECT_FALSE(panel.find<QProgressBar>("progress").isVisible());
}

TEST_F(Panel, RecordsWithoutFfmpegToPngFilesOnly)
{
  const ShownPanel panel;
  ASSERT_TRUE(knows(panel, lineage()));
  const QByteArray path = qgetenv("PATH");
  qputenv("PATH", "/nowhere");
  panel.enter("film", folder_.path() + "/film.mp4");
  panel.press("record");
  EXPECT_TRUE(eventually([&] { return panel.says("film_error", "apt-get install ffmpeg"); }))
      << panel.text("film_note");
  panel.enter("film", folder_.path() + "/film/");
  panel.press("record");
  EXPECT_TRUE(eventually([&] { return panel.says("film_note", "the film is in"); })) << panel.text("film_error");
  EXPECT_EQ(panel.text("film_error"), "");
  EXPECT_TRUE(std::filesystem::exists(folder_.path() + "/film/00000.png"));
  qputenv("PATH", path);
}

TEST_F(Panel, SaysWhereAFilmCannotBeWritten)
{
  const ShownPanel panel;
  ASSERT_TRUE(knows(panel, lineage()));
  panel.enter("film", "film.mp4");
  panel.press("record");
  EXPECT_TRUE(panel.says("film_error", "it must be an absolute path"));
  std::ofstream(folder_.path() + "/file") << "no folder";
  panel.enter("film", folder_.path() + "/file/film.mp4");
  panel.press("record");
  EXPECT_TRUE(eventually([&] { return panel.says("film_error", folder_.path() + "/file"); }))
      << panel.text("film_note");
}

TEST_F(Panel, CancelsAFilm)
{
  settings_.output = folder_.path() + "/long";
  settings_.body.soft.lifetime = 30.0;
  settings_.generations = 0;
  settings_.evolution.population = 2;
  settings_.trials = 1;
  evolveReally(settings_);
  ros::param::set("evolver/output", settings_.output);
  const ShownPanel panel;
  ASSERT_TRUE(knows(panel, lineage()));
  panel.enter("film", folder_.path() + "/film.mp4");
  panel.press("record");
  const auto& progress = panel.find<QProgressBar>("progress");
  EXPECT_TRUE(progress.isVisible());
  ASSERT_TRUE(eventually([&] { return progress.maximum() > 700 && progress.value() > 0; })) << panel.text("film_error");
  panel.press("record");
  EXPECT_TRUE(eventually([&] { return panel.says("film_error", "cancelled"); }));
  EXPECT_EQ(panel.button("record").text(), "Record film");
  EXPECT_FALSE(std::filesystem::exists(folder_.path() + "/film.mp4"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() + "/film.mp4.partial"));
}
}  // namespace
}  // namespace devo_evo

int main(int argc, char** argv)
{
  qputenv("QT_QPA_PLATFORM", "offscreen");
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "panel_rostest");
  ros::start();
  QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
