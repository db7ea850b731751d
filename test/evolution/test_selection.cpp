#include "devo_evo/evolution/selection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace devo_evo;

namespace
{
Candidate valid(int64_t id, int64_t age, double fitness)
{
  return { id, age, true, fitness };
}

Candidate invalid(int64_t id, int64_t age)
{
  return { id, age, false, std::nan("") };
}

RandomStream stream(int64_t generation = 0)
{
  return RandomStream(1, "arm", 0, generation, 0, RandomPurpose::SURVIVOR_DRAW);
}

std::vector<int64_t> idsOf(const std::vector<Candidate>& candidates, const std::vector<size_t>& indices)
{
  std::vector<int64_t> ids;
  for (const size_t index : indices)
  {
    ids.push_back(candidates[index].id);
  }
  return ids;
}

std::vector<int64_t> survivorsOf(const std::vector<Candidate>& candidates, size_t population, int64_t generation = 0)
{
  RandomStream random = stream(generation);
  return idsOf(candidates, selectSurvivors(candidates, population, random));
}

/// Candidates of which none dominates another: the older, the fitter. In ranking order, with ids from 0.
std::vector<Candidate> incomparable(int64_t count)
{
  std::vector<Candidate> candidates;
  for (int64_t id = 0; id < count; ++id)
  {
    candidates.push_back(valid(id, count - id, static_cast<double>(count - id)));
  }
  return candidates;
}
}  // namespace

TEST(Dominance, needsNoStrictWinOfTheDominated)
{
  const Candidate base = valid(1, 5, 10.0);
  EXPECT_TRUE(isDominatedBy(base, valid(2, 4, 11.0)));   // fitter and younger
  EXPECT_TRUE(isDominatedBy(base, valid(2, 5, 11.0)));   // fitter
  EXPECT_TRUE(isDominatedBy(base, valid(2, 4, 10.0)));   // younger
  EXPECT_FALSE(isDominatedBy(base, valid(2, 6, 11.0)));  // fitter but older
  EXPECT_FALSE(isDominatedBy(base, valid(2, 4, 9.0)));   // younger but less fit
  EXPECT_FALSE(isDominatedBy(base, valid(2, 6, 10.0)));  // older
  EXPECT_FALSE(isDominatedBy(base, valid(2, 5, 9.0)));   // less fit
  EXPECT_FALSE(isDominatedBy(base, valid(2, 6, 9.0)));   // less fit and older
}

TEST(Dominance, ofFullTiesGoesToTheNewer)
{
  EXPECT_TRUE(isDominatedBy(valid(1, 5, 10.0), valid(2, 5, 10.0)));
  EXPECT_FALSE(isDominatedBy(valid(2, 5, 10.0), valid(1, 5, 10.0)));
  EXPECT_FALSE(isDominatedBy(valid(1, 5, 10.0), valid(1, 5, 10.0)));  // itself
  // Ids decide nothing else.
  EXPECT_TRUE(isDominatedBy(valid(2, 5, 10.0), valid(1, 4, 10.0)));
}

TEST(Dominance, ofAValidOneNeverBelongsToAnInvalidOne)
{
  EXPECT_FALSE(isDominatedBy(valid(1, 5, -1000.0), invalid(2, 0)));
  EXPECT_FALSE(isDominatedBy(valid(1, 5, -1000.0), invalid(2, 5)));
  EXPECT_TRUE(isDominatedBy(invalid(2, 5), valid(1, 5, -1000.0)));
  EXPECT_FALSE(isDominatedBy(invalid(2, 0), valid(1, 5, -1000.0)));  // younger
}

TEST(Dominance, amongInvalidOnesIsDecidedByAgeAndThenById)
{
  EXPECT_TRUE(isDominatedBy(invalid(2, 5), invalid(1, 4)));
  EXPECT_FALSE(isDominatedBy(invalid(1, 4), invalid(2, 5)));
  EXPECT_TRUE(isDominatedBy(invalid(1, 5), invalid(2, 5)));
}

TEST(Ranking, isByLevelThenFitness)
{
  const std::vector<Candidate> candidates = {
    valid(1, 5, 10.0),                    // dominated by 2
    valid(2, 3, 10.0), valid(3, 5, 8.0),  // dominated by 1 and 2
    valid(4, 0, 2.0),  valid(5, 0, 1.0),  // dominated by 4
  };
  const std::vector<Ranked> ranking = rank(candidates);
  std::vector<int64_t> ids;
  std::vector<size_t> levels;
  for (const Ranked& ranked : ranking)
  {
    ids.push_back(candidates[ranked.index].id);
    levels.push_back(ranked.level);
  }
  EXPECT_EQ((std::vector<int64_t>{ 2, 4, 1, 5, 3 }), ids);
  EXPECT_EQ((std::vector<size_t>{ 0, 0, 1, 1, 2 }), levels);
}

TEST(Ranking, ofEqualFitnessPutsTheYoungerFirst)
{
  // 3 dominates both others, and 2 dominates 1, which is as fit but older.
  const std::vector<Candidate> candidates = { valid(1, 4, 5.0), valid(2, 3, 5.0), valid(3, 3, 6.0) };
  const std::vector<Ranked> ranking = rank(candidates);
  EXPECT_EQ(3, candidates[ranking[0].index].id);
  EXPECT_EQ(2, candidates[ranking[1].index].id);
  EXPECT_EQ(1u, ranking[1].level);
  EXPECT_EQ(1, candidates[ranking[2].index].id);
  EXPECT_EQ(2u, ranking[2].level);
}

TEST(Ranking, putsInvalidOnesBelowEveryValidOne)
{
  // The last valid one has as many dominators as possible; the invalid one has the lowest age.
  std::vector<Candidate> candidates = { invalid(100, 0), invalid(101, 0), invalid(102, 7) };
  for (int64_t id = 0; id < 10; ++id)
  {
    candidates.push_back(valid(id, id + 1, -static_cast<double>(id)));
  }
  const std::vector<Ranked> ranking = rank(candidates);
  for (int64_t place = 0; place < 10; ++place)
  {
    EXPECT_EQ(place, candidates[ranking[place].index].id);
  }
  EXPECT_EQ(101, candidates[ranking[10].index].id);
  EXPECT_EQ(100, candidates[ranking[11].index].id);
  EXPECT_EQ(102, candidates[ranking[12].index].id);
}

TEST(Ranking, doesNotDependOnTheOrderGiven)
{
  std::vector<Candidate> candidates;
  RandomStream random = stream();
  for (int64_t id = 0; id < 40; ++id)
  {
    const int64_t age = static_cast<int64_t>(random.below(4));
    const double fitness = static_cast<double>(random.below(4));
    candidates.push_back(id % 7 == 0 ? invalid(id, age) : valid(id, age, fitness));
  }
  const std::vector<int64_t> ids = survivorsOf(candidates, 40);
  std::reverse(candidates.begin(), candidates.end());
  EXPECT_EQ(ids, survivorsOf(candidates, 40));
}

TEST(Survivors, areAllIfThereIsRoom)
{
  EXPECT_EQ((std::vector<int64_t>{ 0, 1, 2 }), survivorsOf(incomparable(3), 3));
  EXPECT_EQ((std::vector<int64_t>{ 0, 1, 2 }), survivorsOf(incomparable(3), 10));
}

TEST(Survivors, areWholeLevelsWhileTheyFit)
{
  // Levels {2, 4}, {1, 5}, {3} of the ranking above.
  const std::vector<Candidate> candidates = { valid(1, 5, 10.0), valid(2, 3, 10.0), valid(3, 5, 8.0), valid(4, 0, 2.0),
                                              valid(5, 0, 1.0) };
  EXPECT_EQ((std::vector<int64_t>{ 2, 4 }), survivorsOf(candidates, 2));
  EXPECT_EQ((std::vector<int64_t>{ 2, 4, 1 }), survivorsOf(candidates, 3));  // the best of a level that does not fit
  EXPECT_EQ((std::vector<int64_t>{ 2, 4, 1, 5 }), survivorsOf(candidates, 4));
}

TEST(Survivors, includeNoInvalidOneWhileValidOnesAreLeft)
{
  // Five of equal age: levels of one member each.
  std::vector<Candidate> candidates = { invalid(10, 0), invalid(11, 0), invalid(12, 0) };
  for (int64_t id = 0; id < 5; ++id)
  {
    candidates.push_back(valid(id, 9, static_cast<double>(-id)));
  }
  EXPECT_EQ((std::vector<int64_t>{ 0, 1, 2, 3, 4 }), survivorsOf(candidates, 5));
  EXPECT_EQ((std::vector<int64_t>{ 0, 1, 2, 3, 4, 12 }), survivorsOf(candidates, 6));
}

TEST(Survivors, alwaysIncludeTheFittest)
{
  const std::vector<Candidate> candidates = incomparable(61);
  for (int64_t generation = 0; generation < 100; ++generation)
  {
    const std::vector<int64_t> ids = survivorsOf(candidates, 30, generation);
    EXPECT_EQ(0, ids[0]);
    EXPECT_EQ(30u, ids.size());
    EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));  // ranking order
    EXPECT_EQ(ids.end(), std::adjacent_find(ids.begin(), ids.end()));
  }
}

TEST(Survivors, ofALevelThatDoesNotFitAreDrawnByLogarithmicRank)
{
  // One place beside the best: rank i has probability log((i + 1) / i) / log(level size).
  constexpr int64_t draws = 40000;
  const std::vector<Candidate> candidates = incomparable(6);
  std::vector<double> frequency(6, 0.0);
  for (int64_t generation = 0; generation < draws; ++generation)
  {
    ++frequency[survivorsOf(candidates, 2, generation)[1]];
  }
  EXPECT_EQ(0.0, frequency[0]);
  for (size_t i = 1; i < 6; ++i)
  {
    const double p = std::log((i + 1.0) / i) / std::log(6.0);
    EXPECT_NEAR(draws * p, frequency[i], 4.0 * std::sqrt(draws * p * (1.0 - p))) << i;
  }
}

TEST(Survivors, areDrawnWithoutRepetition)
{
  // Two places beside the best: i is drawn first, or after another j, when the others share what j leaves.
  constexpr int64_t draws = 40000;
  const std::vector<Candidate> candidates = incomparable(6);
  std::vector<double> frequency(6, 0.0);
  for (int64_t generation = 0; generation < draws; ++generation)
  {
    const std::vector<int64_t> ids = survivorsOf(candidates, 3, generation);
    ++frequency[ids[1]];
    ++frequency[ids[2]];
  }
  const auto first = [](size_t i) { return std::log((i + 1.0) / i) / std::log(6.0); };
  for (size_t i = 1; i < 6; ++i)
  {
    double p = first(i);
    for (size_t j = 1; j < 6; ++j)
    {
      p += j == i ? 0.0 : first(j) * first(i) / (1.0 - first(j));
    }
    EXPECT_NEAR(draws * p, frequency[i], 4.0 * std::sqrt(draws * p * (1.0 - p))) << i;
  }
}

TEST(Survivors, ofALargePopulationAreFoundInReasonableTime)
{
  const std::vector<Candidate> candidates = incomparable(5000);
  EXPECT_EQ(4999u, survivorsOf(candidates, 4999).size());
}
