#pragma once

#include "ros/node_main.h"

#include <ros/init.h>

#include <cstdlib>

namespace devo_evo
{
/// The rest of the main() of a node that does its work and ends, after ros::init() with NoSigintHandler.
/// @param make makes the node, which has run() and close(); close() tells whether no thread hangs in the network's
/// code.
/// @return the process's exit status.
template <class Make>
int runWorkNode(Make make)
{
  decltype(make()) node;
  const int status = runNode(
      [&]
      {
        ros::start();  // here, so that ROS outlives the node and can tell of what it throws
        node = make();
        node->run();
        return 0;
      });
  const bool clean = !node || node->close();
  node.reset();
  ros::shutdown();
  leaveStatus(status);
  if (!clean)
  {
    std::_Exit(status);  // threads that hang in roscpp must not meet the destruction of static objects
  }
  return status;
}
}  // namespace devo_evo
