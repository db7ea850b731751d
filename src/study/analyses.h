#pragma once

#include "study/champions.h"
#include "study/work.h"

#include <vector>

namespace devo_evo
{
/// Work of one kind, in one world.
struct Analysis
{
  World world;
  bool keep_velocities = true;
  std::vector<WorkMaker> work;  ///< what is not done yet
};

/// What a part that analyses consists of; empty for one that evolves. The database must outlive it.
/// @param champions whom it is about; IMPACT needs none.
std::vector<Analysis> analysesOf(StudyPart part, const Parameters& parameters,
                                 const std::vector<RunChampion>& champions, StudyDatabase& database);
}  // namespace devo_evo
