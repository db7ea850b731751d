#pragma once

#include "devo_evo/experiment/parameters.h"

#include <cstdint>
#include <vector>

namespace devo_evo
{
/// How many robots a part simulates.
struct Workload
{
  StudyPart part;
  int64_t evaluations = 0;  ///< at most; of lineages that are still to evolve, about
  int64_t left = 0;         ///< of these, not done yet
};

/// Of each part that the study runs. @param parameters experiment.output is the study's folder, which need not exist.
std::vector<Workload> workloads(const Parameters& parameters);
}  // namespace devo_evo
