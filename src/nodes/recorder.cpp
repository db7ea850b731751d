#include "ros/node_main.h"
#include "ros/parameters.h"
#include "ros/recorder.h"

#include <ros/ros.h>

#include <chrono>

namespace
{
constexpr std::chrono::seconds LONGEST_END{ 5 };  // in which the others may still publish their last messages

/// What is recorded; relative names are those of an experiment and its player.
const std::vector<std::string> TOPICS = { "settings",     "generation",   "champion",     "best",         "velocity",
                                          "/diagnostics", "player/robot", "player/floor", "player/state", "/tf" };
}  // namespace

/// Records an experiment; docs/nodes.md. Usage: recorder [--parameters NAMESPACE]; those of the evolver.
int main(int argc, char** argv)
{
  using namespace devo_evo;
  ros::init(argc, argv, "recorder", ros::init_options::NoSigintHandler);
  return runNode(
      [&]
      {
        ros::start();  // here, so that ROS outlives the node and can tell of what it throws
        const ScopedInterruption interruption;
        const bool shared = argc == 3 && std::string(argv[1]) == "--parameters";
        const ExperimentSettings settings =
            readParameters(shared ? ros::names::resolve(argv[2]) : ros::this_node::getName()).experiment;
        Recorder recorder({}, settings.output.empty() ? defaultOutput(settings) : settings.output, TOPICS);
        while (ros::ok() && !ScopedInterruption::happened())
        {
          recorder.work();
        }
        const auto end = std::chrono::steady_clock::now() + LONGEST_END;
        // What they have published is written, however long that takes.
        while (ros::ok() && !recorder.nothingComes() &&
               (recorder.publishersAreGone() || std::chrono::steady_clock::now() < end))
        {
          recorder.work();
        }
        recorder.close();
        say(recorder.path().empty()
                ? "nothing was published, so nothing was recorded"
                : "recorded " + std::to_string(recorder.messages()) + " messages to " + recorder.path());
        return 0;
      });
}
