#pragma once

#include "devo_evo/evolution/genome.h"
#include "devo_evo/soft_body/evaluation.h"

#include <cstdint>
#include <optional>

namespace devo_evo
{
/// One robot of a trial, with its place in the lineage.
struct Individual
{
  static constexpr int64_t NO_PARENT = -1;

  int64_t trial = 0;
  int64_t id = 0;              ///< counts up within the trial, from 0
  int64_t parent = NO_PARENT;  ///< id of the parent; NO_PARENT if random
  int64_t generation = 0;      ///< in which it was born
  int64_t age = 0;             ///< generations since the oldest ancestor was random
  Genome genome;
  std::optional<Evaluation> evaluation;  ///< none until evaluated
};

/// "3/1042": individual 1042 of trial 3.
std::string individualName(int64_t trial, int64_t id);
}  // namespace devo_evo
