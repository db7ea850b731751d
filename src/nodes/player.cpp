#include "ros/node_main.h"
#include "ros/parameters.h"
#include "ros/player_node.h"

#include <ros/ros.h>

/// Shows robots; docs/nodes.md.
int main(int argc, char** argv)
{
  using namespace devo_evo;
  ros::init(argc, argv, "player", ros::init_options::NoSigintHandler);
  return runNode(
      []
      {
        ros::start();  // here, so that ROS outlives the node and can tell of what it throws
        PlayerNode node(readParameters(ros::this_node::getName()));
        ros::MultiThreadedSpinner(2).spin();  // an order may wait for a message
        node.throwFailure();
        return 0;
      });
}
