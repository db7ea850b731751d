#include "devo_evo/farm/local_farm.h"

#include "devo_evo/bodies/bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <thread>

namespace devo_evo
{
namespace
{
using std::chrono::milliseconds;
using std::chrono::steady_clock;

SoftBodySettings shortLife()
{
  SoftBodySettings settings;
  settings.grid_x = settings.grid_y = settings.grid_z = 2;
  settings.lifetime = 0.01;
  return settings;
}

/// A robot of eight voxels that no other number gives.
EvaluationRequest request(int64_t number)
{
  EvaluationRequest request;
  request.trial = 1;
  request.id = number;
  const double gene = static_cast<double>(number) / 1000.0;
  request.program = { std::vector<double>(8, gene), std::vector<double>(8, -gene), std::vector<double>(8, 0.1),
                      std::vector<double>(8, gene) };
  return request;
}

std::vector<EvaluationRequest> requests(int64_t count)
{
  std::vector<EvaluationRequest> all;
  for (int64_t i = 0; i < count; ++i)
  {
    all.push_back(request(i));
  }
  return all;
}

/// Collects until a number of answers is there, or patience ends.
std::vector<EvaluationResult> collectAll(Farm& farm, size_t count, milliseconds patience = milliseconds(30000))
{
  std::vector<EvaluationResult> results;
  const auto deadline = steady_clock::now() + patience;
  while (results.size() < count && steady_clock::now() < deadline)
  {
    for (auto& result : farm.collect(milliseconds(100)))
    {
      results.push_back(std::move(result));
    }
  }
  return results;
}

TEST(LocalFarm, AnswersEveryRequestExactlyOnceHoweverManyThreads)
{
  const auto settings = shortLife();
  const int64_t count = 61;
  std::vector<DevelopmentalProgram> programs;
  for (const auto& each : requests(count))
  {
    programs.push_back(each.program);
  }
  const auto expected = evaluate(settings, programs);
  for (const int threads : { 1, 3 })
  {
    const auto farm = makeLocalFarm(makeSoftBody(settings), threads);
    farm->submit(requests(count));
    std::map<int64_t, int> answers;
    for (const EvaluationResult& result : collectAll(*farm, count))
    {
      ++answers[result.id];
      EXPECT_EQ(result.trial, 1);
      EXPECT_EQ(result.evaluation.state_hash, expected[static_cast<size_t>(result.id)].state_hash) << result.id;
    }
    EXPECT_EQ(answers.size(), static_cast<size_t>(count));
    EXPECT_TRUE(std::all_of(answers.begin(), answers.end(), [](const auto& answer) { return answer.second == 1; }));
    EXPECT_TRUE(farm->collect(milliseconds(20)).empty());
  }
}

TEST(LocalFarm, CountsWhatEachThreadDid)
{
  const auto farm = makeLocalFarm(makeSoftBody(shortLife()), 2);
  farm->submit(requests(20));
  collectAll(*farm, 20);
  const auto workers = farm->status();
  ASSERT_EQ(workers.size(), 2u);
  EXPECT_EQ(workers[0].evaluations + workers[1].evaluations, 20);
  EXPECT_TRUE(workers[0].usable() && workers[1].usable());
  EXPECT_EQ(workers[0].name, "thread 1");
}

TEST(LocalFarm, SharesLittleWorkAmongIdleThreads)
{
  const auto farm = makeLocalFarm(makeSoftBody(shortLife()), 2);
  std::set<std::string> workers;
  for (int attempt = 0; attempt < 100 && workers.size() < 2; ++attempt)  // at first one may not be waiting yet
  {
    workers.clear();
    farm->submit(requests(2));
    for (const EvaluationResult& result : collectAll(*farm, 2))
    {
      workers.insert(result.worker);
    }
  }
  EXPECT_EQ(workers.size(), 2u);
}

TEST(LocalFarm, WaitsForWorkUntilTheTimeout)
{
  const auto farm = makeLocalFarm(makeSoftBody(shortLife()), 2);
  const auto start = steady_clock::now();
  EXPECT_TRUE(farm->collect(milliseconds(30)).empty());
  EXPECT_GE(steady_clock::now() - start, milliseconds(30));
}

TEST(LocalFarm, AbandonsItsWorkWhenDestroyed)
{
  SoftBodySettings settings = shortLife();
  settings.lifetime = 1000.0;
  const auto start = steady_clock::now();
  {
    const auto farm = makeLocalFarm(makeSoftBody(settings), 3);
    farm->submit(requests(100));
    while (farm->status()[0].state != WorkerState::WORKING && steady_clock::now() - start < std::chrono::seconds(10))
    {
      std::this_thread::yield();
    }
  }
  EXPECT_LT(steady_clock::now() - start, std::chrono::seconds(10));
}

TEST(LocalFarm, HandsAnErrorOfAThreadToTheCaller)
{
  const auto farm = makeLocalFarm(makeSoftBody(shortLife()), 2);
  EvaluationRequest misfit = request(1);
  misfit.program.control_final.pop_back();
  farm->submit({ misfit });
  EXPECT_THROW(collectAll(*farm, 1), InvalidInput);
  EXPECT_THROW(farm->collect(milliseconds(1)), InvalidInput);
  farm->submit(requests(10));
  EXPECT_THROW(farm->collect(milliseconds(1)), InvalidInput);
}

TEST(LocalFarm, RefusesToHaveNoThreadsOrImpossibleSettings)
{
  EXPECT_THROW(makeLocalFarm(makeSoftBody(shortLife()), 0), InvalidInput);
  SoftBodySettings settings = shortLife();
  settings.lifetime = -1.0;
  EXPECT_THROW(makeLocalFarm(makeSoftBody(settings), 1), InvalidInput);
}
}  // namespace
}  // namespace devo_evo
