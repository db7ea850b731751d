#include "cli/robot_choices.h"

#include <filesystem>

namespace devo_evo
{
bool isExperiment(const std::string& source)
{
  std::error_code ignored;
  return std::filesystem::is_directory(source, ignored);
}

ShownRobot chooseRobot(const std::string& source, const std::string& which, const Parameters& parameters)
{
  if (!isExperiment(source))
  {
    return readRobotFile(source, which, parameters.experiment.body);
  }
  const RobotChoice choice = parseRobotChoice(which.empty() ? "best" : which);
  std::optional<ShownRobot> robot = findRobot(*openArchiveForReading(source), choice);
  if (!robot)
  {
    throw InvalidInput(source + ": there is no valid champion yet" +
                       (choice.trial ? " of a trial " + toString(choice) : std::string()));
  }
  return *std::move(robot);
}
}  // namespace devo_evo
