#include "ros/node_main.h"
#include "ros/parameters.h"
#include "ros/simulator_node.h"

#include <ros/ros.h>

/// Usage: simulator [--parameters NAMESPACE]; its own namespace, unless several share one.
int main(int argc, char** argv)
{
  using namespace devo_evo;
  ros::init(argc, argv, nodeNameOnHost("simulator"),
            ros::init_options::AnonymousName | ros::init_options::NoSigintHandler);
  return runNode(
      [&]
      {
        ros::start();  // here, so that ROS outlives the node and can tell of what it throws
        const bool shared = argc == 3 && std::string(argv[1]) == "--parameters";
        if (argc > 1 && !shared)
        {
          throw InvalidInput(std::string("cannot understand \"") + argv[1] +
                             "\"; usage: simulator [--parameters NAMESPACE]");
        }
        const Parameters parameters = readParameters(shared ? argv[2] : ros::this_node::getName());
        const SimulatorNode node(parseInstructionSet(parameters.instruction_set), parameters.announcement_period);
        ros::spin();
        return 0;
      });
}
