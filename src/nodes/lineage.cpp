#include "ros/picture/lineage_bag.h"
#include "ros/node_main.h"
#include "ros/text_parameters.h"

#include "devo_evo/render/shown_robot.h"
#include "devo_evo/soft_body/text.h"

#include <ros/ros.h>

/// Records the lives of a lineage to a bag, and ends; docs/nodes.md.
int main(int argc, char** argv)
{
  using namespace devo_evo;
  ros::init(argc, argv, "lineage", ros::init_options::NoSigintHandler);
  return runNode(
      []
      {
        ros::start();  // here, so that ROS outlives the work and can tell of what it throws
        const TextParameters parameters(ros::this_node::getName(), { { "output", "" },
                                                                     { "trial", "best" },
                                                                     { "count", "0" },
                                                                     { "bag", "" },
                                                                     { "rate", "25" },
                                                                     { "pause", "1" },
                                                                     { "colour", "resting_length" } });
        const std::string output = parameters.absolutePath("output");
        const std::string path =
            parameters.text("bag").empty() ? output + "/lineage.bag" : parameters.absolutePath("bag");
        LineageBagOptions options;
        options.count = parameters.wholeNumber("count", 0, 1000000);
        options.rate = parameters.number("rate", 1.0, 200.0);
        options.pause = parameters.number("pause", 0.1, 60.0);
        options.colouring = parseColouring(parameters.text("colour"));
        const RobotChoice choice = parseRobotChoice(parameters.text("trial"));
        const auto archive = openArchiveForReading(output);
        const Lineage lineage = readLineage(*archive, choice.trial, choice.id);
        writeLineageBag(*archive, lineage, options, path,
                        [&](size_t done, size_t total)
                        {
                          if (!ros::ok())
                          {
                            throw std::runtime_error("stopped; there is no bag");
                          }
                          ROS_INFO_STREAM("recorded " << done << " of " << total << " individuals");
                        });
        ROS_INFO_STREAM("the lineage is in " << path
                                             << "; watch it with: roslaunch devo_evo replay.launch bag:=" << path);
        return 0;
      });
}
