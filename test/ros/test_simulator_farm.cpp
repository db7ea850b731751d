#include "ros/simulator_farm.h"

#include "ros/conversions.h"
#include "ros/message_fields.h"

#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <map>
#include <mutex>
#include <set>

namespace devo_evo
{
namespace
{
using namespace std::chrono_literals;

constexpr uint64_t FINGERPRINT = 0x0123456789abcdef;

/// Waits for something that another thread is about to bring about.
template <class Condition>
bool eventually(Condition condition)
{
  const auto end = std::chrono::steady_clock::now() + 10s;
  while (!condition())
  {
    if (std::chrono::steady_clock::now() > end)
    {
      return false;
    }
    std::this_thread::sleep_for(1ms);
  }
  return true;
}

SoftBodySettings smallBody()
{
  SoftBodySettings body;
  body.grid_x = 1;
  body.grid_y = 2;
  body.grid_z = 1;
  body.lifetime = 1.0;
  return body;
}

std::vector<EvaluationRequest> robots(int64_t count)
{
  const std::vector<double> zeros(2, 0.0);
  std::vector<EvaluationRequest> requests;
  for (int64_t id = 0; id < count; ++id)
  {
    const double gene = static_cast<double>(id) / 1000.0;
    requests.push_back({ 1, id, { { gene, gene }, zeros, zeros, zeros } });
  }
  return requests;
}

/// What every honest simulator answers for a robot.
Evaluation honestEvaluation(double gene)
{
  Evaluation evaluation;
  evaluation.valid = true;
  evaluation.fitness = gene;
  evaluation.displacement_y_voxels = 2.0 * gene;
  evaluation.displacement_xy_voxels = 2.0 * gene;
  evaluation.turns = 0.0;
  evaluation.airborne_fraction = 0.0;
  evaluation.velocity_body_lengths_per_s = { gene, gene };
  evaluation.state_hash = 7;
  return evaluation;
}

/// A simulator as the farm sees it, and what goes wrong with it.
class FakeSimulator : public SimulatorConnection
{
public:
  bool call(const EvaluateGenomes::Request& request, EvaluateGenomes::Response& response) override
  {
    if (++calls > calls_to_live)
    {
      return false;
    }
    if (request.genomes.empty())
    {
      std::lock_guard<std::mutex> lock(mutex_);
      quarantine_ = request.quarantine;
      return !dead;
    }
    largest_batch = std::max(largest_batch.load(), request.genomes.size());
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return !hangs || (aborted_ && !ignores_abort); });
    if (dead || aborted_)
    {
      return false;
    }
    for (size_t i = 0; i < request.genomes.size(); ++i)
    {
      const double gene = request.genomes[i].arrays.at(0).values.at(0);
      response.evaluations.push_back(toMsg(honestEvaluation(gene), request.trial[i], request.id[i], *body_));
    }
    if (corrupt)
    {
      corrupt(response);
    }
    return true;
  }

  void abort() override
  {
    std::lock_guard<std::mutex> lock(mutex_);
    aborted_ = true;
    changed_.notify_all();
  }

  void stopHanging()
  {
    std::lock_guard<std::mutex> lock(mutex_);
    hangs = false;
    changed_.notify_all();
  }

  /// Why it has been told that it is quarantined; empty if it has not.
  std::string quarantine()
  {
    std::lock_guard<std::mutex> lock(mutex_);
    return quarantine_;
  }

  std::atomic<bool> dead{ false };
  std::atomic<bool> hangs{ false };
  std::atomic<bool> ignores_abort{ false };
  std::function<void(EvaluateGenomes::Response&)> corrupt;
  std::atomic<int> calls{ 0 };
  std::atomic<int> calls_to_live{ 1000 };
  std::atomic<size_t> largest_batch{ 0 };

private:
  const std::shared_ptr<const Body> body_ = makeSoftBody(smallBody());
  std::mutex mutex_;
  std::condition_variable changed_;
  bool aborted_ = false;
  std::string quarantine_;
};

class SimulatorFarmTest : public testing::Test
{
protected:
  SimulatorFarmTest()
  {
    settings_.body = BodySettings(smallBody());
    settings_.engine_fingerprint = FINGERPRINT;
    settings_.silence_timeout = 30s;
    settings_.retry_delay = 1ms;
  }

  void open()
  {
    farm_ = std::make_unique<SimulatorFarm>(
        settings_, [this](const SimulatorAnnouncement& announcement) { return fakes_.at(announcement.name); },
        [this](const DevelopmentalProgram& program, const std::atomic<bool>& /*stop*/)
        {
          ++judged_;
          if (!referee_error_.empty())
          {
            throw std::runtime_error(referee_error_);
          }
          return honestEvaluation(program.morphology_initial[0]);
        });
  }

  FakeSimulator& addFake(const std::string& name)
  {
    fakes_[name] = std::make_shared<FakeSimulator>();
    return *fakes_[name];
  }

  void announce(const std::string& name, uint64_t fingerprint = FINGERPRINT, uint32_t pid = 1)
  {
    SimulatorAnnouncement announcement;
    announcement.name = name;
    announcement.service = name + "/evaluate";
    announcement.host = "host";
    announcement.pid = pid;
    announcement.version = "9.9.9";
    announcement.instruction_set = "avx2";
    announcement.engines.resize(1);
    announcement.engines[0].body = "soft";
    announcement.engines[0].fingerprint = fingerprint;
    announcement.lanes = 4;
    announcement.period = 0.01;
    farm_->heardFrom(announcement);
  }

  FakeSimulator& join(const std::string& name)
  {
    FakeSimulator& fake = addFake(name);
    announce(name);
    EXPECT_TRUE(eventually([&] { return status(name).usable(); }));
    return fake;
  }

  WorkerStatus status(const std::string& name) const
  {
    for (const WorkerStatus& worker : farm_->status())
    {
      if (worker.name == name)
      {
        return worker;
      }
    }
    return {};
  }

  std::string state(const std::string& name) const { return stateText(status(name)); }

  /// Collects until `count` results have come, and a little longer to see whether there are more.
  std::vector<EvaluationResult> collect(size_t count)
  {
    std::vector<EvaluationResult> results;
    EXPECT_TRUE(eventually(
        [&]
        {
          const auto some = farm_->collect(10ms);
          results.insert(results.end(), some.begin(), some.end());
          return results.size() >= count;
        }));
    const auto surplus = farm_->collect(20ms);
    results.insert(results.end(), surplus.begin(), surplus.end());
    return results;
  }

  static void expectEachOnce(const std::vector<EvaluationResult>& results, int64_t count)
  {
    std::set<int64_t> ids;
    for (const EvaluationResult& result : results)
    {
      EXPECT_TRUE(ids.insert(result.id).second) << "answered twice: " << result.id;
      EXPECT_EQ(result.evaluation.fitness, static_cast<double>(result.id) / 1000.0);
      EXPECT_EQ(result.evaluation.state_hash, 7u) << result.id << " by " << result.worker;
    }
    EXPECT_EQ(ids.size(), static_cast<size_t>(count));
  }

  SimulatorFarmSettings settings_;
  std::map<std::string, std::shared_ptr<FakeSimulator>> fakes_;
  std::atomic<int> judged_{ 0 };
  std::string referee_error_;
  std::unique_ptr<SimulatorFarm> farm_;
};

TEST_F(SimulatorFarmTest, AnswersEveryRequestExactlyOnce)
{
  open();
  join("/a");
  join("/b");
  join("/c");
  farm_->submit(robots(100));
  expectEachOnce(collect(100), 100);
  EXPECT_EQ(status("/a").evaluations + status("/b").evaluations + status("/c").evaluations, 100);
}

TEST_F(SimulatorFarmTest, RequestsWaitForTheFirstSimulator)
{
  open();
  farm_->submit(robots(5));
  EXPECT_TRUE(farm_->collect(20ms).empty());
  join("/late");
  expectEachOnce(collect(5), 5);
}

TEST_F(SimulatorFarmTest, NoBatchIsLargerThanTheSimulatorsLanes)
{
  open();
  const FakeSimulator& only = join("/a");
  farm_->submit(robots(30));
  expectEachOnce(collect(30), 30);
  EXPECT_EQ(only.largest_batch, 4u);
}

TEST_F(SimulatorFarmTest, ABatchLeavesWorkForEverybodyElse)
{
  open();
  const FakeSimulator& a = join("/a");
  const FakeSimulator& b = join("/b");
  farm_->submit(robots(4));
  expectEachOnce(collect(4), 4);
  EXPECT_LE(a.largest_batch, 2u);
  EXPECT_LE(b.largest_batch, 2u);
}

TEST_F(SimulatorFarmTest, TheRobotsOfASimulatorThatDiesGoToAnother)
{
  open();
  FakeSimulator& victim = join("/victim");
  victim.hangs = true;
  farm_->submit(robots(3));
  ASSERT_TRUE(eventually([&] { return state("/victim") == "working"; }));
  victim.dead = true;
  victim.stopHanging();
  ASSERT_TRUE(eventually([&] { return !status("/victim").usable(); }));
  EXPECT_EQ(state("/victim"), "lost: the connection failed");
  join("/heir");
  expectEachOnce(collect(3), 3);
}

TEST_F(SimulatorFarmTest, ASimulatorThatTakesTooLongIsGivenUp)
{
  settings_.batch_timeout = 100ms;
  open();
  FakeSimulator& slow = join("/slow");
  slow.hangs = true;
  farm_->submit(robots(3));
  ASSERT_TRUE(eventually([&] { return !status("/slow").usable(); }));
  EXPECT_EQ(state("/slow"), "lost: no answer within 0.1 s");
  join("/quick");
  expectEachOnce(collect(3), 3);
}

TEST_F(SimulatorFarmTest, LargerBodiesMayTakeLonger)
{
  settings_.batch_timeout = 10ms;
  settings_.body = BodySettings();
  settings_.body.soft.grid_x = settings_.body.soft.grid_y = settings_.body.soft.grid_z = 8;
  settings_.body.soft.lifetime = 997.0;  // with settling, 95 times the paper's 10.5 s
  open();
  FakeSimulator& slow = join("/slow");
  slow.hangs = true;
  const std::vector<double> zeros(512, 0.0);
  farm_->submit({ { 1, 0, { zeros, zeros, zeros, zeros } } });
  ASSERT_TRUE(eventually([&] { return state("/slow") == "working"; }));
  std::this_thread::sleep_for(100ms);
  EXPECT_EQ(state("/slow"), "working");
}

TEST_F(SimulatorFarmTest, AnAnswerThatComesTooLateIsNotCountedTwice)
{
  settings_.batch_timeout = 100ms;
  open();
  FakeSimulator& slow = join("/slow");
  slow.hangs = true;
  slow.ignores_abort = true;
  farm_->submit(robots(3));
  ASSERT_TRUE(eventually([&] { return !status("/slow").usable(); }));
  join("/quick");
  const auto results = collect(3);
  slow.stopHanging();
  expectEachOnce(results, 3);
  EXPECT_TRUE(farm_->collect(50ms).empty());
}

TEST_F(SimulatorFarmTest, ACallThatCannotBeAbortedDelaysTheEndByTwoSecondsAtMost)
{
  open();
  FakeSimulator& stuck = join("/stuck");
  stuck.hangs = true;
  stuck.ignores_abort = true;
  farm_->submit(robots(1));
  ASSERT_TRUE(eventually([&] { return state("/stuck") == "working"; }));
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(farm_->close());
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 4s);
  stuck.stopHanging();
  EXPECT_TRUE(farm_->close());
}

TEST_F(SimulatorFarmTest, ClosingAbortsCallsAndIsPrompt)
{
  open();
  join("/a").hangs = true;
  farm_->submit(robots(1));
  ASSERT_TRUE(eventually([&] { return state("/a") == "working"; }));
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_TRUE(farm_->close());
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 1s);
}

TEST_F(SimulatorFarmTest, ASimulatorThatFallsSilentIsGivenUp)
{
  settings_.silence_timeout = 150ms;
  open();
  join("/a").hangs = true;
  farm_->submit(robots(2));
  ASSERT_TRUE(eventually([&] { return state("/a") == "lost: no sign of life for 0.15 s"; }));
}

TEST_F(SimulatorFarmTest, ALostSimulatorIsTakenInAgainWhenItAnnouncesItself)
{
  open();
  FakeSimulator& first = join("/a");
  first.dead = true;
  farm_->submit(robots(2));
  ASSERT_TRUE(eventually([&] { return !status("/a").usable(); }));
  addFake("/a");  // what the next connection leads to
  ASSERT_TRUE(eventually(
      [&]
      {
        announce("/a");
        return status("/a").usable();
      }));
  expectEachOnce(collect(2), 2);
}

TEST_F(SimulatorFarmTest, ASimulatorThatKeepsFailingIsAskedLessAndLess)
{
  settings_.retry_delay = 20ms;
  open();
  addFake("/a").dead = true;
  const auto end = std::chrono::steady_clock::now() + 300ms;
  while (std::chrono::steady_clock::now() < end)
  {
    announce("/a");
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_LE(fakes_["/a"]->calls, 5) << "after 0, 20, 60, 140 and 300 ms";
}

TEST_F(SimulatorFarmTest, AnotherEngineIsRefusedAndToldSo)
{
  open();
  FakeSimulator& stranger = addFake("/stranger");
  farm_->submit(robots(2));
  announce("/stranger", 0xfedcba9876543210);
  ASSERT_TRUE(eventually([&] { return stranger.calls == 1; }));
  announce("/stranger", 0xfedcba9876543210);
  EXPECT_EQ(state("/stranger"),
            "refused: its engine fingerprint for soft bodies is fedcba9876543210, that of this evolver is "
            "0123456789abcdef; its version "
            "is 9.9.9");
  EXPECT_FALSE(status("/stranger").usable());
  join("/friend");
  expectEachOnce(collect(2), 2);
  EXPECT_EQ(stranger.calls, 1);
  EXPECT_EQ(stranger.largest_batch, 0u);
}

TEST_F(SimulatorFarmTest, NonsenseIsNotAcceptedFromAnybody)
{
  const double nan = Evaluation::NONE;
  const std::vector<std::function<void(EvaluateGenomes::Response&)>> corruptions = {
    [](EvaluateGenomes::Response& answer) { answer.evaluations.pop_back(); },
    [](EvaluateGenomes::Response& answer) { answer.evaluations.push_back(answer.evaluations[0]); },
    [](EvaluateGenomes::Response& answer) { answer.evaluations[0].id = 99; },
    [](EvaluateGenomes::Response& answer) { answer.evaluations[0].trial = 2; },
    [&](EvaluateGenomes::Response& answer) { answer.evaluations[0].fitness = nan; },
    [](EvaluateGenomes::Response& answer) { answer.evaluations[0].fitness += 1.0; },
    [&](EvaluateGenomes::Response& answer) { test::valueOf(answer.evaluations[0].measures, "turns") = nan; },
    [](EvaluateGenomes::Response& answer) { test::valueOf(answer.evaluations[0].measures, "airborne_fraction") = 1.5; },
    [](EvaluateGenomes::Response& answer)
    { test::valueOf(answer.evaluations[0].measures, "fell_over_since_birth_s") = 2.0; },
    [](EvaluateGenomes::Response& answer) { answer.evaluations[0].velocity.clear(); },
    [](EvaluateGenomes::Response& answer) { answer.evaluations[0].valid = false; },
    [](EvaluateGenomes::Response& answer) { answer.error = "no"; },
  };
  open();
  for (size_t i = 0; i < corruptions.size(); ++i)
  {
    const std::string name = "/liar_" + std::to_string(i);
    join(name).corrupt = corruptions[i];
  }
  farm_->submit(robots(static_cast<int64_t>(corruptions.size())));
  for (size_t i = 0; i < corruptions.size(); ++i)
  {
    const std::string name = "/liar_" + std::to_string(i);
    EXPECT_TRUE(eventually([&] { return !status(name).usable(); })) << name;
    EXPECT_EQ(status(name).evaluations, 0) << name << " " << state(name);
  }
  join("/honest");
  expectEachOnce(collect(corruptions.size()), static_cast<int64_t>(corruptions.size()));
}

TEST_F(SimulatorFarmTest, ALateSimulatorsBatchIsDoneByOthersAndItIsGivenUp)
{
  settings_.shortest_lateness = 50ms;
  open();
  FakeSimulator& slow = join("/slow");
  farm_->submit(robots(1));
  expectEachOnce(collect(1), 1);  // what is usual
  slow.hangs = true;
  farm_->submit(robots(3));
  ASSERT_TRUE(eventually([&] { return status("/slow").state == WorkerState::LATE; }));
  EXPECT_TRUE(status("/slow").usable());
  join("/quick");
  expectEachOnce(collect(3), 3);
  ASSERT_TRUE(eventually([&] { return status("/slow").state == WorkerState::LOST; }));
  EXPECT_NE(state("/slow").find("lost: others have done its batch meanwhile; no answer for "), std::string::npos)
      << state("/slow");
}

TEST_F(SimulatorFarmTest, ALateSimulatorMayStillAnswer)
{
  settings_.shortest_lateness = 50ms;
  open();
  FakeSimulator& slow = join("/slow");
  farm_->submit(robots(1));
  expectEachOnce(collect(1), 1);
  slow.hangs = true;
  farm_->submit(robots(3));
  ASSERT_TRUE(eventually([&] { return status("/slow").state == WorkerState::LATE; }));
  slow.stopHanging();
  expectEachOnce(collect(3), 3);
  EXPECT_TRUE(eventually([&] { return state("/slow") == "idle"; }));
}

/// Another evaluation than everybody else's, but one that nobody can see anything wrong with.
void tellWrongHash(EvaluateGenomes::Response& answer)
{
  for (auto& evaluation : answer.evaluations)
  {
    evaluation.state_hash = 8;
  }
}

TEST_F(SimulatorFarmTest, AWrongEvaluationIsFoundAndItsSimulatorQuarantined)
{
  settings_.checked_fraction = 1.0;
  open();
  join("/liar").corrupt = tellWrongHash;
  join("/honest");
  farm_->submit(robots(20));
  const auto results = collect(20);
  expectEachOnce(results, 20);
  EXPECT_EQ(status("/liar").state, WorkerState::QUARANTINED);
  EXPECT_NE(state("/liar").find("has state hash 0000000000000008 and fitness "), std::string::npos) << state("/liar");
  EXPECT_TRUE(status("/honest").usable());
  EXPECT_GT(status("/honest").checked, 0);
  EXPECT_GT(judged_, 0);
}

TEST_F(SimulatorFarmTest, AQuarantinedSimulatorGetsNoWorkUntilAnotherProcessHasItsName)
{
  settings_.checked_fraction = 1.0;
  open();
  FakeSimulator& liar = join("/liar");
  liar.corrupt = tellWrongHash;
  join("/honest");
  farm_->submit(robots(4));
  collect(4);
  ASSERT_EQ(status("/liar").state, WorkerState::QUARANTINED);
  announce("/liar");
  ASSERT_TRUE(eventually([&] { return !liar.quarantine().empty(); }));
  const int calls = liar.calls;
  announce("/liar");
  farm_->submit(robots(4));
  collect(4);
  EXPECT_EQ(status("/liar").state, WorkerState::QUARANTINED);
  EXPECT_EQ(liar.calls, calls);
  addFake("/liar");
  announce("/liar", FINGERPRINT, 2);
  EXPECT_TRUE(eventually([&] { return status("/liar").usable(); }));
}

TEST_F(SimulatorFarmTest, AQuarantinedSimulatorIsToldWhyUntilItAnswers)
{
  settings_.checked_fraction = 1.0;
  open();
  join("/liar").corrupt = tellWrongHash;
  const std::shared_ptr<FakeSimulator> liar = fakes_.at("/liar");  // outlives its place there
  join("/honest");
  farm_->submit(robots(4));
  collect(4);
  ASSERT_EQ(status("/liar").state, WorkerState::QUARANTINED);
  addFake("/liar").dead = true;  // what the next connection leads to
  ASSERT_TRUE(eventually(
      [&]
      {
        announce("/liar");
        return fakes_.at("/liar")->calls >= 2;
      }));
  fakes_.at("/liar")->dead = false;
  ASSERT_TRUE(eventually(
      [&]
      {
        announce("/liar");
        return fakes_.at("/liar")->calls > 2;
      }));
  EXPECT_EQ("quarantined: " + fakes_.at("/liar")->quarantine(), state("/liar"));
  EXPECT_EQ(liar->quarantine(), "");
}

TEST_F(SimulatorFarmTest, WhatALiarSaidBeforeInTheSameGenerationIsMadeAgain)
{
  settings_.checked_fraction = 0.1;
  open();
  join("/liar").corrupt = tellWrongHash;
  farm_->submit(robots(40));
  ASSERT_TRUE(eventually([&] { return status("/liar").state == WorkerState::QUARANTINED; }));
  join("/honest");
  const auto results = collect(40);
  expectEachOnce(results, 40);
}

TEST_F(SimulatorFarmTest, WithOneSimulatorTheEvolverItselfChecks)
{
  settings_.checked_fraction = 1.0;
  open();
  join("/only");
  farm_->submit(robots(6));
  expectEachOnce(collect(6), 6);
  EXPECT_EQ(judged_, 6);
  EXPECT_EQ(status("/only").checked, 6);
}

TEST_F(SimulatorFarmTest, AloneALiarIsQuarantinedAndItsRobotsWait)
{
  settings_.checked_fraction = 1.0;
  open();
  join("/liar").corrupt = tellWrongHash;
  farm_->submit(robots(6));
  ASSERT_TRUE(eventually([&] { return status("/liar").state == WorkerState::QUARANTINED; }));
  EXPECT_TRUE(farm_->collect(20ms).empty());
  join("/honest");
  expectEachOnce(collect(6), 6);
}

TEST_F(SimulatorFarmTest, AfterNonsenseEarlierAnswersOfTheSameGenerationAreNotTrusted)
{
  open();
  FakeSimulator& unsound = join("/unsound");
  unsound.corrupt = [&](EvaluateGenomes::Response& answer)
  {
    if (unsound.calls > 2)
    {
      answer.evaluations[0].fitness = Evaluation::NONE;
    }
    else
    {
      tellWrongHash(answer);
    }
  };
  farm_->submit(robots(8));
  ASSERT_TRUE(eventually([&] { return !status("/unsound").usable(); }));
  join("/honest");
  const auto results = collect(8);
  expectEachOnce(results, 8);
}

TEST_F(SimulatorFarmTest, AnErrorOfTheEvolversOwnEvaluationIsNotHidden)
{
  settings_.checked_fraction = 1.0;
  referee_error_ = "out of memory";
  open();
  join("/only");
  farm_->submit(robots(1));
  EXPECT_THROW(
      {
        for (int i = 0; i < 1000; ++i)
        {
          farm_->collect(10ms);
        }
      },
      std::runtime_error);
}

TEST_F(SimulatorFarmTest, AProgramThatDoesNotFitTheBodyIsNotSubmitted)
{
  open();
  auto requests = robots(1);
  requests[0].program.control_final.pop_back();
  EXPECT_THROW(farm_->submit(requests), InvalidInput);
}

TEST_F(SimulatorFarmTest, ManyComeAndGoAndNothingIsLost)
{
  open();
  farm_->submit(robots(400));
  std::vector<EvaluationResult> results;
  for (int i = 0; results.size() < 300 && i < 1000; ++i)
  {
    const std::string name = "/mortal_" + std::to_string(i);
    addFake(name).calls_to_live = 3;  // a greeting, two batches
    announce(name);
    const auto some = farm_->collect(1ms);
    results.insert(results.end(), some.begin(), some.end());
  }
  join("/immortal");
  const auto rest = collect(400 - results.size());
  results.insert(results.end(), rest.begin(), rest.end());
  expectEachOnce(results, 400);
}
}  // namespace
}  // namespace devo_evo
