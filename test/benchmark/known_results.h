#pragma once

#include "devo_evo/soft_body/evaluation.h"

#include <cstdint>
#include <string>
#include <vector>

namespace devo_evo
{
/// One hash over robots' validity, fitness and final states, in their order.
uint64_t combinedHash(const std::vector<Evaluation>& evaluations);

/// Compares a scene's results with those in known_results.txt: a benchmark of something else tells nothing.
/// @throw std::runtime_error if they differ, or if the scene is not in the file.
void verifyResults(const std::string& scene, uint64_t hash);
}  // namespace devo_evo
