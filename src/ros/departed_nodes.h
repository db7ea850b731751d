#pragma once

#include <chrono>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>

namespace devo_evo
{
/// Which nodes have been heard of lately. Functions may be called from different threads.
class SignsOfLife
{
public:
  using Clock = std::chrono::steady_clock;

  /// @param lasts for how long the node counts as living, if nothing more is heard of it.
  void note(const std::string& node, Clock::duration lasts);

  /// Nobody listens any more, until the next note().
  void stopListening();

  /// Names of the living; nothing if nobody listens, or has heard anything yet.
  std::optional<std::set<std::string>> living();

private:
  std::mutex mutex_;
  bool listening_ = false;
  std::map<std::string, Clock::time_point> until_;
};

/// Takes nodes that are gone off the ROS master's books. The master keeps a node that was killed for ever, and roscpp
/// tries to connect to every publisher that the master names whenever it names another one: after thousands of killed
/// simulators, a new one would cost every subscriber of `simulators` thousands of connections at once.
///
/// A node that is taken off by mistake, because a cable was unplugged for long, registers again (MasterWatch).
class DepartedNodes
{
public:
  /// @param topic that the nodes publish, resolved. @param patience in how many checks in a row a publisher must not be
  /// among the living before it is taken off, 1 or more.
  DepartedNodes(std::string topic, int patience) : topic_(std::move(topic)), patience_(patience) {}

  /// Asks the master who publishes. May take minutes if the network loses packets. @param living names of nodes of
  /// which something has been heard lately; if that is not known, counting begins anew.
  void check(const std::optional<std::set<std::string>>& living);

private:
  const std::string topic_;
  const int patience_;
  std::map<std::string, int> silent_checks_;  // by node
};
}  // namespace devo_evo
