#include "ros/node_main.h"
#include "ros/picture/renderer_node.h"
#include "ros/text_parameters.h"

#include <ros/ros.h>

/// Draws what a player shows, without a display; docs/nodes.md.
int main(int argc, char** argv)
{
  using namespace devo_evo;
  ros::init(argc, argv, "renderer", ros::init_options::NoSigintHandler);
  return runNode(
      []
      {
        ros::start();  // here, so that ROS outlives the node and can tell of what it throws
        const TextParameters parameters(ros::this_node::getName(),
                                        { { "width", "1280" }, { "height", "720" }, { "rate", "25" }, { "film", "" } });
        RendererOptions options;
        options.width = static_cast<int>(parameters.wholeNumber("width", 16, Image::MAXIMUM_SIDE));
        options.height = static_cast<int>(parameters.wholeNumber("height", 16, Image::MAXIMUM_SIDE));
        options.rate = static_cast<int>(parameters.wholeNumber("rate", 1, 120));
        options.film = parameters.text("film").empty() ? "" : parameters.absolutePath("film");
        RendererNode node(options);
        ros::spin();
        node.close();
        return 0;
      });
}
