#include "devo_evo/experiment/scale.h"
#include "ros/parameters.h"
#include "ros/study_node.h"
#include "ros/work_node.h"

#include <ros/ros.h>

int main(int argc, char** argv)
{
  using namespace devo_evo;
  ros::init(argc, argv, "study", ros::init_options::NoSigintHandler);
  return runWorkNode(
      []
      {
        const std::string name = ros::this_node::getName();
        return std::make_unique<StudyNode>(readParameters(name, parametersAtScale(readParameters(name).study.scale)));
      });
}
