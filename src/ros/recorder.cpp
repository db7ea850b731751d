#include "ros/recorder.h"

#include "devo_evo/soft_body/text.h"
#include "ros/conversions.h"

#include <ros/console.h>
#include <ros/subscribe_options.h>
#include <rosbag/exceptions.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace devo_evo
{
namespace
{
constexpr uint32_t UNLIMITED = 0;
const char* const ACTIVE = ".active";
const ros::WallDuration PATIENCE(0.05);

/// The first of run-1.bag, run-2.bag ... that there is not, nor was being written when its writer died.
std::string freePath(const std::string& folder)
{
  for (int64_t number = 1;; ++number)
  {
    const std::string path = folder + "/run-" + toText(number) + ".bag";
    if (!std::filesystem::exists(path) && !std::filesystem::exists(path + ACTIVE))
    {
      return path;
    }
  }
}

/// The destructor of a bag that cannot be written would write again, and throw.
void neverDestroy(std::unique_ptr<rosbag::Bag> bag)
{
  [[maybe_unused]] static rosbag::Bag* kept = nullptr;
  kept = bag.release();
}
}  // namespace

Recorder::Recorder(ros::NodeHandle node, std::string folder, const std::vector<std::string>& topics)
  : node_(std::move(node)), folder_(std::move(folder))
{
  node_.setCallbackQueue(&queue_);
  for (const std::string& topic : topics)
  {
    const std::string resolved = node_.resolveName(topic);
    ros::SubscribeOptions options;
    options.initByFullCallbackType<const Event&>(resolved, UNLIMITED,
                                                 [this, resolved](const Event& event) { write(resolved, event); });
    options.transport_hints.tcpNoDelay();
    subscribers_.push_back(node_.subscribe(options));
  }
}

void Recorder::work()
{
  try
  {
    queue_.callAvailable(PATIENCE);
  }
  catch (const rosbag::BagException& e)
  {
    neverDestroy(std::move(bag_));
    throw std::runtime_error("cannot go on recording to " + path_ + ACTIVE + ": " + e.what() +
                             "; what it holds can be read after: rosbag reindex");
  }
}

bool Recorder::publishersAreGone() const
{
  const auto silent = [](const ros::Subscriber& subscriber) { return subscriber.getNumPublishers() == 0; };
  return std::all_of(subscribers_.begin(), subscribers_.end(), silent);
}

bool Recorder::nothingComes()
{
  // In this order: a last message is in the queue before its publisher is gone.
  return publishersAreGone() && queue_.isEmpty();
}

void Recorder::write(const std::string& topic, const Event& event)
{
  if (path_.empty())
  {
    open();
  }
  bag_->write(topic, wallStamp(), *event.getMessage(), event.getConnectionHeaderPtr());
  ++messages_;
}

void Recorder::open()
{
  std::filesystem::create_directories(folder_);
  const std::string path = freePath(folder_);
  bag_ = std::make_unique<rosbag::Bag>(path + ACTIVE, rosbag::bagmode::Write);
  bag_->setCompression(rosbag::compression::LZ4);
  path_ = path;
  ROS_INFO_STREAM("recording to " << path_);
}

void Recorder::close()
{
  subscribers_.clear();
  if (path_.empty())
  {
    return;
  }
  try
  {
    bag_->close();
    std::filesystem::rename(path_ + ACTIVE, path_);
  }
  catch (const std::exception& e)
  {
    neverDestroy(std::move(bag_));
    throw std::runtime_error("cannot end the recording " + path_ + ACTIVE + ": " + e.what());
  }
}
}  // namespace devo_evo
