#pragma once

#include "devo_evo/experiment/study_settings.h"
#include "devo_evo/soft_body/settings.h"

#include <optional>
#include <string>
#include <vector>

namespace devo_evo
{
/// What else than the genome a simulation depends on (docs/study.md, "worlds").
struct World
{
  std::string name;             ///< "as_evolved", "friction*0.5", "slope=0.1"
  std::string quantity;         ///< that is changed; "none"
  std::optional<double> value;  ///< factor, or slope
  SoftBodySettings body;
};

World asEvolved(const SoftBodySettings& body);

/// The world that robots evolved in, and those in which their robustness is tried.
/// @throw InvalidInput if one of them cannot be simulated.
std::vector<World> robustnessWorlds(const SoftBodySettings& body, const StudySettings& study);
}  // namespace devo_evo
