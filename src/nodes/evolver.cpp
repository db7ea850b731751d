#include "ros/evolver_node.h"
#include "ros/parameters.h"
#include "ros/work_node.h"

#include <ros/ros.h>

int main(int argc, char** argv)
{
  using namespace devo_evo;
  ros::init(argc, argv, "evolver", ros::init_options::NoSigintHandler);
  return runWorkNode([] { return std::make_unique<EvolverNode>(readParameters(ros::this_node::getName())); });
}
