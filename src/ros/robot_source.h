#pragma once

#include "devo_evo/render/shown_robot.h"
#include "devo_evo/soft_body/settings.h"

#include <devo_evo/EvolvedRobot.h>

#include <ros/node_handle.h>

#include <memory>
#include <optional>
#include <string>

namespace devo_evo
{
/// Where a player has its robot from. Used by one thread at a time, but for stop().
class RobotSource
{
public:
  virtual ~RobotSource() = default;

  /// The robot that is to be shown now; none if there is none yet.
  /// @throw InvalidInput if there will never be one, ArchiveError if the archive cannot be read now.
  virtual std::optional<ShownRobot> look() = 0;

  /// What is missing while there is none, for people.
  virtual std::string waitingFor() const = 0;

  /// Ends a look() that may be going on in another thread.
  virtual void stop() {}
};

/// Follows or looks up robots in the archive of a folder, which may be written to meanwhile.
/// @throw ArchiveError, InvalidInput if there is no archive or no such individual.
std::unique_ptr<RobotSource> makeArchiveSource(const std::string& output, const RobotChoice& choice);

/// A robot of a file. @throw InvalidInput
std::unique_ptr<RobotSource> makeFileSource(const std::string& path, const std::string& id, const BodySettings& body);

/// The robot that a message speaks of. @param settings of the experiment that it is from.
/// @throw InvalidInput if the message makes no sense for this body, or has no genome.
ShownRobot robotOf(const EvolvedRobot& message, const BodySettings& settings);

/// Follows or asks an evolver by its topics `settings`, `champion` and `best` and its service `individual`.
std::unique_ptr<RobotSource> makeEvolverSource(ros::NodeHandle node, const RobotChoice& choice);
}  // namespace devo_evo
