#include "ros/evolver_node.h"
#include "ros/node_main.h"
#include "ros/parameters.h"

#include <ros/ros.h>

#include <cstdlib>

int main(int argc, char** argv)
{
  using namespace devo_evo;
  ros::init(argc, argv, "evolver", ros::init_options::NoSigintHandler);
  std::unique_ptr<EvolverNode> node;
  const int status = runNode(
      [&]
      {
        ros::start();  // here, so that ROS outlives the node and can tell of what it throws
        node = std::make_unique<EvolverNode>(readParameters(ros::this_node::getName()));
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
