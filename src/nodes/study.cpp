#include "devo_evo/experiment/scale.h"
#include "ros/node_main.h"
#include "ros/parameters.h"
#include "ros/study_node.h"

#include <ros/ros.h>

#include <cstdlib>
#include <memory>

int main(int argc, char** argv)
{
  using namespace devo_evo;
  ros::init(argc, argv, "study", ros::init_options::NoSigintHandler);
  std::unique_ptr<StudyNode> node;
  const int status = runNode(
      [&]
      {
        ros::start();  // here, so that ROS outlives the node and can tell of what it throws
        const std::string name = ros::this_node::getName();
        node = std::make_unique<StudyNode>(readParameters(name, parametersAtScale(readParameters(name).study.scale)));
        node->run();
        return 0;
      });
  const bool clean = !node || node->clean();
  node.reset();
  ros::shutdown();
  leaveStatus(status);
  if (!clean)
  {
    std::_Exit(status);  // threads that hang in roscpp must not meet the destruction of static objects
  }
  return status;
}
