#pragma once

#include "devo_evo/archive/archive.h"

#include <cstdint>
#include <string>
#include <vector>

namespace devo_evo
{
/// An individual and its ancestors, oldest first: its line of descent.
struct Lineage
{
  ExperimentSettings settings;  ///< of the experiment that it is from
  std::vector<ArchivedIndividual> individuals;
};

/// @param trial  none: that of the best robot of all trials.
/// @param id     of the individual; none: the trial's champion.
/// @throw InvalidInput if there is no such individual, or no champion yet.
Lineage readLineage(const Archive& archive, std::optional<int64_t> trial, std::optional<int64_t> id);

/// Positions in a lineage, ascending, at equal steps from the first to the last, which are always among them.
/// @param count how many at most; 0: all. @throw InvalidInput if it is negative or 1 of several.
std::vector<size_t> evenlySpaced(size_t lineage_size, int64_t count);

/// Positions in a lineage that tell how it came to its end: the founder, whoever first exceeds each of equal steps from
/// the founder's fitness to the highest, and the last.
std::vector<size_t> stepsOfProgress(const Lineage& lineage, int64_t count);

/// What a robot does, in a few words: "rolls 9 times, from 0.4 s after birth", "walks and falls over 9.1 s after
/// birth", "gallops".
std::string behaviourText(const Evaluation& evaluation, const Body& body);
}  // namespace devo_evo
