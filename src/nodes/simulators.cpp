#include "devo_evo/soft_body/simulation.h"
#include "ros/node_main.h"
#include "ros/parameters.h"
#include "ros/simulator_processes.h"

#include <ros/ros.h>

/// Keeps simulators running on this machine, as many as parameter `simulators` says.
int main(int argc, char** argv)
{
  using namespace devo_evo;
  std::vector<std::string> arguments = inheritedArguments(argc, argv);
  // Reads its parameters, but is no node of its own: nobody talks to it.
  ros::init(argc, argv, "simulators", ros::init_options::NoSigintHandler | ros::init_options::NoRosout);
  return runNode(
      [&]
      {
        const Parameters parameters = readParameters(ros::this_node::getName());
        parseInstructionSet(parameters.instruction_set);
        arguments.insert(arguments.end(), { "--parameters", ros::this_node::getName() });
        const int count = parameters.simulators == 0 ? coreCount() : parameters.simulators;
        return runProcesses(siblingProgram("simulator"), arguments, count);
      });
}
