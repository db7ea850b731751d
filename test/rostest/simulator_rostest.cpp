// What a simulator answers, refuses and publishes. Runs beside simulators "best", "scalar" and "wrong"
// (simulator.test).

#include "devo_evo/soft_body/simulation.h"
#include "ros/conversions.h"
#include "ros/departed_nodes.h"
#include "ros/master_calls.h"
#include "ros/message_fields.h"

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Log.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <functional>
#include <map>
#include <set>
#include <thread>

namespace devo_evo
{
namespace
{
using test::setValue;
using test::valuesOf;

SoftBodySettings shortLife()
{
  SoftBodySettings settings;
  settings.lifetime = 0.7;
  settings.dynamic_friction = 0.6;
  return settings;
}

/// Robots that differ; numbers in eighths, which every text and message keeps.
std::vector<EvaluationRequest> robots(int64_t count, const SoftBodySettings& settings)
{
  const auto value = [](int64_t seed) { return static_cast<double>(seed * 37 % 17 - 8) / 8.0; };
  std::vector<EvaluationRequest> requests(static_cast<size_t>(count));
  for (int64_t id = 0; id < count; ++id)
  {
    EvaluationRequest& request = requests[static_cast<size_t>(id)];
    request.trial = 2;
    request.id = id;
    for (int64_t voxel = 0; voxel < settings.voxelCount(); ++voxel)
    {
      request.program.morphology_initial.push_back(value(voxel + 5 * id) / 2.0);
      request.program.morphology_final.push_back(value(voxel + 7 * id) / 2.0);
      request.program.control_initial.push_back(value(3 * voxel + id) / 4.0);
      request.program.control_final.push_back(value(5 * voxel + id) / 4.0);
    }
  }
  return requests;
}

EvaluateGenomes::Request requestFor(const std::vector<EvaluationRequest>& requests, const SoftBodySettings& settings,
                                    uint64_t fingerprint)
{
  return toRequest(requests, BodySettings(settings), *makeSoftBody(settings), fingerprint);
}

std::vector<DevelopmentalProgram> programsOf(const std::vector<EvaluationRequest>& requests)
{
  std::vector<DevelopmentalProgram> programs;
  for (const EvaluationRequest& request : requests)
  {
    programs.push_back(request.program);
  }
  return programs;
}

template <class Condition>
bool eventually(Condition condition)
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

class SimulatorTest : public testing::Test
{
protected:
  SimulatorTest()
  {
    announcements_ = node_.subscribe("simulators", 100, &SimulatorTest::heardFrom, this);
    velocity_ = node_.subscribe("velocity", 1000, &SimulatorTest::tookTelemetry, this);
  }

  void SetUp() override
  {
    ASSERT_TRUE(eventually([this] { return heard_.count("/farm/best") == 1 && heard_.count("/farm/scalar") == 1; }));
  }

  void heardFrom(const SimulatorAnnouncement& announcement)
  {
    heard_[announcement.name] = announcement;
    ++announcement_count_;
    busy_count_ += announcement.busy ? 1 : 0;
  }

  void tookTelemetry(const VelocityTelemetry& telemetry) { telemetry_[telemetry.id] = telemetry; }

  static EvaluateGenomes::Response ask(const std::string& simulator, const EvaluateGenomes::Request& request)
  {
    EvaluateGenomes call;
    call.request = request;
    EXPECT_TRUE(ros::service::call("/farm/" + simulator + "/evaluate", call));
    return call.response;
  }

  ros::NodeHandle node_;
  ros::Subscriber announcements_;
  ros::Subscriber velocity_;
  std::map<std::string, SimulatorAnnouncement> heard_;
  int announcement_count_ = 0;
  int busy_count_ = 0;
  std::map<int64_t, VelocityTelemetry> telemetry_;
};

TEST_F(SimulatorTest, AnnouncesWhoItIs)
{
  const SimulatorAnnouncement& best = heard_["/farm/best"];
  validate(best);
  EXPECT_EQ(best.service, "/farm/best/evaluate");
  EXPECT_EQ(fingerprintFor("soft", best), engineFingerprint());
  EXPECT_EQ(fingerprintFor("rigid", best),
            makeRigidBody(RigidBodySettings())->engineFingerprint(InstructionSet::SCALAR));
  EXPECT_EQ(fingerprintFor("liquid", best), 0u);
  EXPECT_EQ(best.lanes, laneCount(bestInstructionSet()));
  EXPECT_EQ(best.period, 0.1);
  const SimulatorAnnouncement& scalar = heard_["/farm/scalar"];
  EXPECT_EQ(fingerprintFor("soft", scalar), fingerprintFor("soft", best));
  EXPECT_EQ(fingerprintFor("rigid", scalar), fingerprintFor("rigid", best));
  EXPECT_EQ(scalar.instruction_set, "scalar");
  EXPECT_EQ(scalar.lanes, 1);
  EXPECT_NE(scalar.pid, best.pid);
}

TEST_F(SimulatorTest, AnswersAsTheLibraryDoesToTheLastBit)
{
  const SoftBodySettings settings = shortLife();
  const auto requests = robots(11, settings);
  const auto expected = evaluate(settings, programsOf(requests));
  for (const std::string simulator : { "best", "scalar" })
  {
    const auto response = ask(simulator, requestFor(requests, settings, engineFingerprint()));
    ASSERT_EQ(response.error, "");
    const auto answered = evaluationsOf(response, requests, *makeSoftBody(settings));
    for (size_t i = 0; i < requests.size(); ++i)
    {
      ASSERT_TRUE(expected[i].valid);
      EXPECT_EQ(answered[i].state_hash, expected[i].state_hash);
      EXPECT_EQ(std::memcmp(&answered[i].fitness, &expected[i].fitness, sizeof(double)), 0);
      EXPECT_EQ(answered[i].velocity_body_lengths_per_s, expected[i].velocity_body_lengths_per_s);
    }
  }
}

TEST_F(SimulatorTest, RefusesNonsenseAndGoesOn)
{
  const SoftBodySettings settings = shortLife();
  const auto sound = requestFor(robots(2, settings), settings, 0);
  const double nan = Evaluation::NONE;
  const std::vector<std::function<void(EvaluateGenomes::Request&)>> corruptions = {
    [](EvaluateGenomes::Request& request) { request.engine_fingerprint = 12345; },
    [](EvaluateGenomes::Request& request) { setValue(request.settings, "grid", "0x4x3"); },
    [](EvaluateGenomes::Request& request) { setValue(request.settings, "grid", "4x4x2000000000"); },
    [](EvaluateGenomes::Request& request) { setValue(request.settings, "grid", "5x4x3"); },
    [](EvaluateGenomes::Request& request) { setValue(request.settings, "lifetime", "nan"); },
    [](EvaluateGenomes::Request& request) { setValue(request.settings, "lifetime", "1e300"); },
    [](EvaluateGenomes::Request& request) { setValue(request.settings, "time_step_fraction", "-1"); },
    [](EvaluateGenomes::Request& request) { request.trial.pop_back(); },
    [](EvaluateGenomes::Request& request) { request.id.push_back(1); },
    [](EvaluateGenomes::Request& request) { valuesOf(request.genomes[1], "phase_final").resize(1000); },
    [](EvaluateGenomes::Request& request) { valuesOf(request.genomes[1], "size_gene_initial").clear(); },
    [&](EvaluateGenomes::Request& request) { valuesOf(request.genomes[0], "phase_initial")[7] = nan; },
    [](EvaluateGenomes::Request& request) { valuesOf(request.genomes[0], "size_gene_final")[0] = -1.5; },
    [](EvaluateGenomes::Request& request) { request.genomes[0].body = "rigid"; },
    [](EvaluateGenomes::Request& request) { request.settings = devo_evo::toMsg(BodySettings(RigidBodySettings())); },
    [](EvaluateGenomes::Request& request) { request.quarantine = "and evaluate these"; },
    [](EvaluateGenomes::Request& request)
    {
      request.genomes.resize(65, request.genomes[0]);
      request.trial.resize(65);
      request.id.resize(65);
    },
  };
  for (size_t i = 0; i < corruptions.size(); ++i)
  {
    EvaluateGenomes::Request request = sound;
    corruptions[i](request);
    const auto response = ask("best", request);
    EXPECT_NE(response.error, "") << "corruption " << i;
    EXPECT_TRUE(response.evaluations.empty()) << "corruption " << i;
  }
  EXPECT_EQ(ask("best", sound).error, "");
}

TEST_F(SimulatorTest, SimulatesRigidBodiesAsTheLibraryDoes)
{
  RigidBodySettings settings;
  settings.lifetime = 0.7;
  const std::shared_ptr<const Body> body = makeRigidBody(settings);
  std::vector<EvaluationRequest> requests(3);
  for (int64_t id = 0; id < 3; ++id)
  {
    const double length = 0.25 * static_cast<double>(id + 1);
    requests[static_cast<size_t>(id)] = { 1,
                                          id,
                                          { std::vector<double>(4, length), std::vector<double>(4, 0.0),
                                            std::vector<double>(8, length), std::vector<double>(8, -length) } };
  }
  const auto expected = body->evaluate(programsOf(requests), InstructionSet::SCALAR);
  for (const std::string simulator : { "best", "scalar" })
  {
    const auto response = ask(
        simulator, toRequest(requests, BodySettings(settings), *body, body->engineFingerprint(InstructionSet::SCALAR)));
    ASSERT_EQ(response.error, "");
    const auto answered = evaluationsOf(response, requests, *body);
    for (size_t i = 0; i < requests.size(); ++i)
    {
      EXPECT_EQ(answered[i].state_hash, expected[i].state_hash);
      EXPECT_EQ(answered[i].fitness, expected[i].fitness);
      EXPECT_EQ(answered[i].body_measures.size(), expected[i].body_measures.size());
    }
  }
}

TEST_F(SimulatorTest, ARequestWithoutRobotsIsWelcome)
{
  const auto response = ask("best", requestFor({}, shortLife(), engineFingerprint()));
  EXPECT_EQ(response.error, "");
  EXPECT_TRUE(response.evaluations.empty());
}

TEST_F(SimulatorTest, AQuarantinedSimulatorSaysSoAndEvaluatesNothingMore)
{
  std::vector<rosgraph_msgs::Log> errors;
  const boost::function<void(const rosgraph_msgs::Log&)> take = [&](const rosgraph_msgs::Log& log)
  {
    if (log.name == "/farm/wrong" && log.level == rosgraph_msgs::Log::ERROR)
    {
      errors.push_back(log);
    }
  };
  ros::Subscriber log = node_.subscribe<rosgraph_msgs::Log>("/rosout", 100, take);
  ASSERT_TRUE(eventually([&] { return heard_.count("/farm/wrong") == 1 && log.getNumPublishers() >= 4; }));

  EvaluateGenomes::Request request = requestFor({}, shortLife(), engineFingerprint());
  request.quarantine = "its evaluation of robot 3/17 has state hash 8";
  EXPECT_EQ(ask("wrong", request).error, "");
  ASSERT_TRUE(eventually([&] { return !errors.empty(); }));
  const std::string reason = "quarantined by " + ros::this_node::getName() + ": " + request.quarantine;
  EXPECT_EQ(errors[0].msg.find(reason + ". This simulator evaluates nothing any more."), 0u) << errors[0].msg;

  const auto response = ask("wrong", requestFor(robots(1, shortLife()), shortLife(), 0));
  EXPECT_EQ(response.error, "this simulator was " + reason);
  EXPECT_TRUE(response.evaluations.empty());
  const auto before = heard_["/farm/wrong"].header.stamp;
  EXPECT_TRUE(eventually([&] { return heard_["/farm/wrong"].header.stamp > before; })) << "it is still announced";
}

TEST_F(SimulatorTest, PublishesTheVelocityOfEveryRobot)
{
  const SoftBodySettings settings = shortLife();
  ASSERT_TRUE(eventually([this] { return velocity_.getNumPublishers() == 3; }));
  ask("best", requestFor(robots(3, settings), settings, 0));
  ASSERT_TRUE(eventually([this] { return telemetry_.size() == 3; }));
  for (const auto& [id, telemetry] : telemetry_)
  {
    EXPECT_EQ(telemetry.trial, 2);
    EXPECT_EQ(telemetry.simulator, "/farm/best");
    EXPECT_TRUE(telemetry.valid);
    EXPECT_EQ(telemetry.window_end, (std::vector<double>{ 0.5, 0.7 }));
    ASSERT_EQ(telemetry.velocity.size(), 2u);
    // Windows end with time steps, so their weighted mean is that of the life but for a step's worth.
    const double mean = (0.5 * telemetry.velocity[0] + 0.2 * telemetry.velocity[1]) / 0.7;
    EXPECT_NEAR(telemetry.mean_velocity, mean, 0.01);
  }
}

/// What simulators show.
class Display
{
public:
  explicit Display(ros::NodeHandle& node) : subscriber_(node.subscribe("voxels", 100, &Display::took, this)) {}

  bool isConnected() const { return subscriber_.getNumPublishers() == 3; }

  /// Of all pictures so far, in the order in which they came.
  std::vector<visualization_msgs::Marker> markers(const std::string& name_space) const
  {
    const auto found = markers_.find(name_space);
    return found == markers_.end() ? std::vector<visualization_msgs::Marker>() : found->second;
  }

  size_t pictures() const { return markers("caption").size(); }

private:
  void took(const visualization_msgs::MarkerArray& picture)
  {
    for (const visualization_msgs::Marker& marker : picture.markers)
    {
      markers_[marker.ns].push_back(marker);
    }
  }

  std::map<std::string, std::vector<visualization_msgs::Marker>> markers_;
  ros::Subscriber subscriber_;
};

TEST_F(SimulatorTest, ShowsTheBestRobotOfItsLastBatchWhileSomebodySubscribes)
{
  const SoftBodySettings settings = shortLife();
  const auto requests = robots(8, settings);
  const std::vector<Evaluation> evaluations = evaluate(settings, programsOf(requests));
  const auto worse = [](const Evaluation& a, const Evaluation& b) { return a.fitness < b.fitness; };
  const auto best = std::max_element(evaluations.begin(), evaluations.end(), worse) - evaluations.begin();
  ask("best", requestFor(requests, settings, 0));  // nobody subscribes yet: this batch is not shown

  const Display display(node_);
  ASSERT_TRUE(eventually([&] { return display.isConnected(); }));
  ros::WallDuration(0.5).sleep();
  ros::spinOnce();
  EXPECT_EQ(display.pictures(), 0u);
  ask("best", requestFor(requests, settings, 0));
  ASSERT_TRUE(eventually([&] { return display.pictures() > 0; }));
  EXPECT_EQ(display.markers("parts").front().points.size(), 48u);
  EXPECT_EQ(display.markers("caption").front().text, individualName(2, best));
  EXPECT_EQ(display.markers("body").front().lifetime, ros::Duration(2.0));
}

TEST_F(SimulatorTest, ShowsQuadrupedsWithAllTheirParts)
{
  RigidBodySettings world;
  world.lifetime = 1.0;
  const std::shared_ptr<const Body> body = makeRigidBody(world);
  const EvaluationRequest walker = { 2,
                                     5,
                                     { std::vector<double>(4, 1.0), std::vector<double>(4, 1.0),
                                       std::vector<double>(8, 1.0), std::vector<double>(8, 1.0) } };
  const Display display(node_);
  ASSERT_TRUE(eventually([&] { return display.isConnected(); }));
  ASSERT_EQ(ask("scalar", toRequest({ walker }, BodySettings(world), *body, 0)).error, "");
  ASSERT_TRUE(eventually([&] { return display.pictures() >= 3; }));
  EXPECT_EQ(display.markers("caption").front().text, individualName(2, 5));
  const auto bodies = display.markers("body");
  ASSERT_GE(bodies.size(), 5u);
  const int place = bodies[0].id;  // among the simulators
  EXPECT_EQ(place % 100, 0);
  for (int part = 0; part < 5; ++part)
  {
    EXPECT_EQ(bodies[static_cast<size_t>(part)].id, place + part) << "abdomen, then legs";
    EXPECT_FALSE(bodies[static_cast<size_t>(part)].points.empty());
  }
  // Swinging all its legs, the robot moves: so do the centres of its parts.
  const auto parts = display.markers("parts");
  ASSERT_EQ(parts.front().points.size(), 5u);
  const auto& first = parts.front().points[1];
  const auto& last = parts.back().points[1];
  EXPECT_GT(std::hypot(last.x - first.x, last.y - first.y, last.z - first.z), 0.01);
}

/// Names of the nodes that publish `simulators`, as the master has it.
std::set<std::string> registeredSimulators()
{
  XmlRpc::XmlRpcValue state;
  EXPECT_TRUE(callMaster("getSystemState", {}, state));
  std::set<std::string> nodes;
  for (int i = 0; i < state[0].size(); ++i)
  {
    for (int k = 0; std::string(state[0][i][0]) == "/farm/simulators" && k < state[0][i][1].size(); ++k)
    {
      nodes.insert(state[0][i][1][k]);
    }
  }
  return nodes;
}

TEST_F(SimulatorTest, WhoIsNotHeardOfForLongIsTakenOffTheMastersBooks)
{
  const std::string node = "/farm/killed_long_ago";
  const std::string uri = "http://localhost:9";
  XmlRpc::XmlRpcValue answer;
  ASSERT_TRUE(
      callMaster("registerPublisher", { "/farm/simulators", "devo_evo/SimulatorAnnouncement", uri }, answer, node));
  ASSERT_TRUE(callMaster("registerService", { node + "/evaluate", "rosrpc://localhost:9", uri }, answer, node));
  const std::set<std::string> living = { "/farm/best", "/farm/scalar", "/farm/wrong" };
  DepartedNodes departed("/farm/simulators", 2);
  departed.check(living);
  EXPECT_EQ(registeredSimulators().count(node), 1u) << "after one check of two";
  departed.check(std::nullopt);
  departed.check(living);
  EXPECT_EQ(registeredSimulators().count(node), 1u) << "while nobody listens, nobody is blamed for silence";
  departed.check(living);
  EXPECT_EQ(registeredSimulators(), living);
  EXPECT_FALSE(callMaster("lookupService", { node + "/evaluate" }, answer));
  EXPECT_FALSE(callMaster("lookupNode", { node }, answer));
}

TEST_F(SimulatorTest, ASimulatorThatWasTakenOffTheMastersBooksRegistersAgain)
{
  const std::set<std::string> all = registeredSimulators();
  ASSERT_EQ(all.count("/farm/scalar"), 1u);
  DepartedNodes("/farm/simulators", 1).check(std::set<std::string>{ "/farm/best", "/farm/wrong" });
  EXPECT_EQ(registeredSimulators().count("/farm/scalar"), 0u);
  EXPECT_TRUE(eventually([&] { return registeredSimulators() == all; }));
  EXPECT_EQ(ask("scalar", requestFor({}, shortLife(), engineFingerprint())).error, "");
}

TEST(SignsOfLife, LastAsLongAsTheyAreSaidTo)
{
  SignsOfLife signs;
  EXPECT_EQ(signs.living(), std::nullopt);
  signs.note("/a", std::chrono::hours(1));
  signs.note("/b", std::chrono::nanoseconds(0));
  EXPECT_EQ(signs.living(), (std::set<std::string>{ "/a" }));
  signs.stopListening();
  EXPECT_EQ(signs.living(), std::nullopt);
}

TEST_F(SimulatorTest, AnnouncesItselfWhileItSimulates)
{
  const SoftBodySettings settings = shortLife();
  const auto request = requestFor(robots(8, settings), settings, 0);
  std::atomic<bool> enough{ false };
  std::thread caller(
      [&]
      {
        while (!enough)
        {
          ask("scalar", request);
        }
      });
  EXPECT_TRUE(eventually([this] { return busy_count_ >= 3; }));
  enough = true;
  caller.join();
}
}  // namespace
}  // namespace devo_evo

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "simulator_rostest");
  return RUN_ALL_TESTS();
}
