#include "ros/robot_source.h"

namespace devo_evo
{
namespace
{
class ArchiveSource : public RobotSource
{
public:
  ArchiveSource(std::string output, const RobotChoice& choice) : output_(std::move(output)), choice_(choice) { look(); }

  /// Opens the archive anew each time: nothing is held while an evolver writes.
  std::optional<ShownRobot> look() override
  {
    if (!robot_ || choice_.follows())
    {
      robot_ = findRobot(*openArchiveForReading(output_), choice_);
    }
    return robot_;
  }

  std::string waitingFor() const override
  {
    return choice_.trial ? "trial " + toString(choice_) + " has no generation in " + archivePath(output_) + " yet"
                         : "there is no valid robot in " + archivePath(output_) + " yet";
  }

private:
  const std::string output_;
  const RobotChoice choice_;
  std::optional<ShownRobot> robot_;
};

class FileSource : public RobotSource
{
public:
  explicit FileSource(ShownRobot robot) : robot_(std::move(robot)) {}

  std::optional<ShownRobot> look() override { return robot_; }
  std::string waitingFor() const override { return ""; }

private:
  const ShownRobot robot_;
};
}  // namespace

std::unique_ptr<RobotSource> makeArchiveSource(const std::string& output, const RobotChoice& choice)
{
  return std::make_unique<ArchiveSource>(output, choice);
}

std::unique_ptr<RobotSource> makeFileSource(const std::string& path, const std::string& id, const BodySettings& body)
{
  return std::make_unique<FileSource>(readRobotFile(path, id, body));
}
}  // namespace devo_evo
