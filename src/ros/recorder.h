#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <rosbag/bag.h>
#include <topic_tools/shape_shifter.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace devo_evo
{
/// Writes what is published on some topics to a bag, with no message left out: what comes faster than it can be written
/// waits in memory. The bag is `run-N.bag` in a folder, with the first number that is free; while it is being written
/// it is called `run-N.bag.active`. It is made when the first message comes. Not thread-safe.
class Recorder
{
public:
  /// @param topics resolved or relative to the node handle's namespace.
  Recorder(ros::NodeHandle node, std::string folder, const std::vector<std::string>& topics);

  /// Writes what has come, and waits for more for a moment. @throw std::runtime_error if it cannot be written.
  void work();

  /// Whether nobody publishes any of the topics any more; what they have sent may still have to be written.
  bool publishersAreGone() const;

  /// Whether nobody publishes any of the topics any more and everything that came is written.
  bool nothingComes();

  /// Ends the bag properly. @throw std::runtime_error if it cannot be written.
  void close();

  /// Path of the bag; empty while there is none.
  const std::string& path() const { return path_; }

  int64_t messages() const { return messages_; }

private:
  using Event = ros::MessageEvent<topic_tools::ShapeShifter const>;

  void write(const std::string& topic, const Event& event);
  void open();

  ros::NodeHandle node_;
  const std::string folder_;
  ros::CallbackQueue queue_;
  std::vector<ros::Subscriber> subscribers_;
  std::unique_ptr<rosbag::Bag> bag_;
  std::string path_;
  int64_t messages_ = 0;
};
}  // namespace devo_evo
