#pragma once

#include <functional>
#include <string>

namespace devo_evo
{
/// Runs the body of a node's main(), after ros::init() with NoSigintHandler: SIGINT, SIGTERM and SIGHUP shut ROS down,
/// and an exception is logged as one clear line. Assertions of ROS do not end it: surviveAssertions().
/// @return the process's exit status: that of the body; 1 after an exception.
int runNode(const std::function<int()>& body);

/// From now on a ROS_ASSERT that fails says so, and the program goes on, as it does with the ROS of its makers, who
/// compile it without assertions; Debian leaves them in. One of them can fail when a publisher ends while roscpp
/// connects to it on a busy machine: its thread for retries then overtakes the one that makes the first connection.
void surviveAssertions();

/// Logs a message also where ROS has been shut down, after which its log says nothing more.
void say(const std::string& text);

/// While one lives, SIGINT, SIGTERM and SIGHUP are only noted, so that work can be brought to a clean end before ROS is
/// shut down.
class ScopedInterruption
{
public:
  ScopedInterruption();
  ~ScopedInterruption();

  ScopedInterruption(const ScopedInterruption&) = delete;
  ScopedInterruption& operator=(const ScopedInterruption&) = delete;

  /// Whether there has been such a signal, ever.
  static bool happened();
};

/// Writes the exit status to the file that environment variable DEVO_EVO_STATUS_FILE names, if any: roslaunch keeps the
/// status to itself.
void leaveStatus(int status);

/// A name to start an anonymous one from, which tells where the node runs: "simulator_laptop".
std::string nodeNameOnHost(const std::string& kind);

/// Name of the host that this process runs on.
std::string hostName();
}  // namespace devo_evo
