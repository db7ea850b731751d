#include "devo_evo/evolution/selection.h"

#include "evolution/portable_math.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace devo_evo
{
namespace
{
/// Makes every comparison go against an invalid candidate; two of them are equally unfit.
double comparableFitness(const Candidate& candidate)
{
  return candidate.valid ? candidate.fitness : -std::numeric_limits<double>::infinity();
}

/// Draws places different members of a level, the best always among them, and the others with a probability that falls
/// with their rank i as log(1 + 1 / i).
/// @return ranks within the level, ascending.
std::vector<size_t> drawFromLevel(size_t level_size, size_t places, RandomStream& random)
{
  std::vector<double> log_of_rank(level_size + 1);  // that of 0 is never used
  for (size_t rank = 1; rank <= level_size; ++rank)
  {
    log_of_rank[rank] = portableLog(static_cast<double>(rank));
  }
  std::vector<bool> drawn(level_size, false);
  drawn[0] = true;
  for (size_t count = 1; count < places;)
  {
    // Rank i is where the draw falls into [log i, log(i + 1)), out of [0, log(level_size)).
    const double draw = random.uniform() * log_of_rank[level_size];
    const auto above = std::upper_bound(log_of_rank.begin() + 1, log_of_rank.end() - 1, draw);
    const size_t rank = static_cast<size_t>(above - log_of_rank.begin()) - 1;
    if (!drawn[rank])
    {
      drawn[rank] = true;
      ++count;
    }
  }
  std::vector<size_t> ranks;
  for (size_t rank = 0; rank < level_size; ++rank)
  {
    if (drawn[rank])
    {
      ranks.push_back(rank);
    }
  }
  return ranks;
}

/// Different candidates, all sets of them equally likely.
std::vector<size_t> drawUniformly(size_t count, size_t places, RandomStream& random)
{
  std::vector<size_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  const size_t drawn = std::min(count, places);
  for (size_t place = 0; place < drawn; ++place)
  {
    std::swap(order[place], order[place + random.below(count - place)]);
  }
  order.resize(drawn);
  return order;
}

/// Some of the candidates, in the order of rank() among them.
std::vector<size_t> ranked(const std::vector<Candidate>& candidates, const std::vector<size_t>& some)
{
  std::vector<Candidate> chosen;
  for (const size_t index : some)
  {
    chosen.push_back(candidates[index]);
  }
  std::vector<size_t> order;
  for (const Ranked& place : rank(chosen))
  {
    order.push_back(some[place.index]);
  }
  return order;
}

/// The fittest; of equals the younger, and then the newer.
std::vector<size_t> fittest(const std::vector<Candidate>& candidates, size_t places)
{
  const auto key = [&candidates](size_t index)
  {
    const Candidate& candidate = candidates[index];
    return std::make_tuple(-comparableFitness(candidate), candidate.age, -candidate.id);
  };
  std::vector<size_t> order(candidates.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&key](size_t a, size_t b) { return key(a) < key(b); });
  order.resize(std::min(order.size(), places));
  return order;
}
}  // namespace

bool isDominatedBy(const Candidate& a, const Candidate& b)
{
  const double fitness_a = comparableFitness(a);
  const double fitness_b = comparableFitness(b);
  if (fitness_a == fitness_b && a.age == b.age)
  {
    return b.id > a.id;
  }
  return !(fitness_a > fitness_b) && !(a.age < b.age);
}

std::vector<Ranked> rank(const std::vector<Candidate>& candidates)
{
  std::vector<Ranked> ranking;
  ranking.reserve(candidates.size());
  for (size_t i = 0; i < candidates.size(); ++i)
  {
    const Candidate& candidate = candidates[i];
    const auto dominators =
        std::count_if(candidates.begin(), candidates.end(),
                      [&candidate](const Candidate& other) { return isDominatedBy(candidate, other); });
    // No valid candidate can have as many dominators as there are candidates.
    const size_t penalty = candidate.valid ? 0 : candidates.size();
    ranking.push_back({ i, static_cast<size_t>(dominators) + penalty });
  }
  const auto key = [&candidates](const Ranked& ranked)
  {
    const Candidate& candidate = candidates[ranked.index];
    return std::make_tuple(ranked.level, -comparableFitness(candidate), candidate.age, -candidate.id);
  };
  std::sort(ranking.begin(), ranking.end(), [&key](const Ranked& a, const Ranked& b) { return key(a) < key(b); });
  return ranking;
}

std::vector<size_t> selectSurvivors(const std::vector<Candidate>& candidates, size_t population, RandomStream& random)
{
  const std::vector<Ranked> ranking = rank(candidates);
  std::vector<size_t> survivors;
  for (size_t first = 0; first < ranking.size() && survivors.size() < population;)
  {
    size_t end = first;
    while (end < ranking.size() && ranking[end].level == ranking[first].level)
    {
      ++end;
    }
    const size_t places = population - survivors.size();
    if (end - first <= places)
    {
      for (size_t i = first; i < end; ++i)
      {
        survivors.push_back(ranking[i].index);
      }
    }
    else
    {
      for (const size_t i : drawFromLevel(end - first, places, random))
      {
        survivors.push_back(ranking[first + i].index);
      }
    }
    first = end;
  }
  return survivors;
}

std::vector<size_t> selectSurvivors(Selection selection, const std::vector<Candidate>& candidates, size_t population,
                                    RandomStream& random)
{
  switch (selection)
  {
    case Selection::NEUTRAL:
      return ranked(candidates, drawUniformly(candidates.size(), population, random));
    case Selection::RANDOM_SEARCH:
      return fittest(candidates, population);
    case Selection::AFPO:
      break;
  }
  return selectSurvivors(candidates, population, random);
}
}  // namespace devo_evo
