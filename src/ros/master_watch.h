#pragma once

#include "ros/departed_nodes.h"

#include <memory>
#include <string>
#include <vector>

namespace devo_evo
{
/// Keeps this node known to the ROS master, and others off its books that are gone (DepartedNodes). A master that was
/// started anew knows nobody, and roscpp does not tell it; so nodes that start then would not find this one. What is
/// connected already goes on without a master.
///
/// Looks every two seconds, in a thread of its own, and says what it finds.
class MasterWatch
{
public:
  /// @param services resolved names of the services that this node offers; of topics roscpp itself keeps a list.
  /// @param signs_of_life of the publishers of a topic, which are taken off the master's books once they have not been
  /// among the living for twenty seconds. None: nobody is taken off. @param topic its resolved name.
  explicit MasterWatch(std::vector<std::string> services, std::shared_ptr<SignsOfLife> signs_of_life = nullptr,
                       const std::string& topic = "");
  ~MasterWatch();

  MasterWatch(const MasterWatch&) = delete;
  MasterWatch& operator=(const MasterWatch&) = delete;

  /// Ends the thread. @return false if it hangs in a call to a master that does not answer; it will do no harm, but
  /// must not see the end of main().
  bool close();

private:
  class State;

  const std::shared_ptr<State> state_;
};
}  // namespace devo_evo
