#pragma once

#include "devo_evo/study/study.h"
#include "study/study_database.h"

#include <functional>
#include <string>
#include <vector>

namespace devo_evo
{
/// What must be simulated before something can be written.
struct Work
{
  std::vector<DevelopmentalProgram> robots;  ///< those of equal phenotype are simulated once, ever
  std::function<void()> write;               ///< called in a transaction once all robots have been simulated
};

/// Makes a piece of work when its turn comes: what is to be done may be large.
using WorkMaker = std::function<Work()>;

/// Does work on robots in one world: simulates what the database does not have yet, and writes. Whatever was simulated
/// is kept within seconds, even if the work that wanted it is not finished.
/// @param title           what is being done, for progress.
/// @param keep_velocities whether results need their velocity windows.
/// @return false if the observer stopped it; done again, it goes on.
bool doWork(const std::string& title, const World& world, bool keep_velocities, const std::vector<WorkMaker>& work,
            StudyDatabase& database, const FarmFactory& make_farm, StudyObserver& observer);
}  // namespace devo_evo
