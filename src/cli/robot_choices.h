#pragma once

#include "devo_evo/archive/archive.h"
#include "devo_evo/experiment/parameters.h"
#include "devo_evo/render/shown_robot.h"

#include <memory>
#include <string>

namespace devo_evo
{
/// Whether a source is an experiment's output folder, not a file of robots.
bool isExperiment(const std::string& source);

/// The robot that a command names. @param source an experiment's output folder, or a file of JSON lines.
/// @param which in an experiment "best", a trial or trial/id, in a file the robot's id; empty: the best, or the first.
/// @param parameters body and physics for robots of files. @throw InvalidInput, ArchiveError
ShownRobot chooseRobot(const std::string& source, const std::string& which, const Parameters& parameters);
}  // namespace devo_evo
