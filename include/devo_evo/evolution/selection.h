#pragma once

#include "devo_evo/evolution/random.h"
#include "devo_evo/evolution/settings.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace devo_evo
{
/// What selection looks at.
struct Candidate
{
  int64_t id = 0;
  int64_t age = 0;       ///< [generations]
  bool valid = false;    ///< false: below every valid one in every ranking
  double fitness = 0.0;  ///< [body lengths], not NaN; ignored unless valid
};

/// A candidate's place in the ranking.
struct Ranked
{
  size_t index;  ///< into the candidates given
  size_t level;  ///< how many candidates dominate it; for an invalid one, added to the number of candidates
};

/// Whether `a` is dominated by `b` (docs/evolution.md, "Selection"): `a` is strictly better in neither fitness nor age;
/// of full ties the newer, with the higher id, dominates the older. Invalid candidates are equally fit, and less than
/// others.
bool isDominatedBy(const Candidate& a, const Candidate& b);

/// All candidates by level, then fitness (falling), then age (rising), then id (falling).
std::vector<Ranked> rank(const std::vector<Candidate>& candidates);

/// Age-Fitness-Pareto selection as the paper's released code does it: whole levels while they fit; of the first that
/// does not, the best and a logarithmic-rank draw of the others.
/// @return indices of the survivors, in ranking order; all candidates if there are no more than `population`.
std::vector<size_t> selectSurvivors(const std::vector<Candidate>& candidates, size_t population, RandomStream& random);

/// The same by any kind of selection. The fittest of the survivors comes first; the others in the order of rank() among
/// them, under random search by fitness.
std::vector<size_t> selectSurvivors(Selection selection, const std::vector<Candidate>& candidates, size_t population,
                                    RandomStream& random);
}  // namespace devo_evo
