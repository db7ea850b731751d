#pragma once

#include "ros/message_reader.h"

#include <ros/console.h>
#include <ros/node_handle.h>
#include <topic_tools/shape_shifter.h>

#include <functional>
#include <string>
#include <vector>

namespace devo_evo
{
/// The message in what was received in whatever type. @throw InvalidInput if it is none of this type.
template <class Message>
Message readMessage(const topic_tools::ShapeShifter& received)
{
  if (received.getMD5Sum() != ros::message_traits::md5sum<Message>())
  {
    throw InvalidInput("it is of type " + received.getDataType() + " or of another version of devo_evo");
  }
  ros::SerializedMessage bytes;
  bytes.num_bytes = received.size();
  bytes.buf.reset(new uint8_t[bytes.num_bytes]);
  bytes.message_start = bytes.buf.get();
  ros::serialization::OStream stream(bytes.message_start, received.size());
  received.write(stream);
  return readMessage<Message>(bytes);
}

/// Subscribes as node.subscribe() does, except that roscpp does not read messages: those that readMessage() refuses are
/// dropped with a warning.
template <class Message>
ros::Subscriber subscribeChecked(ros::NodeHandle& node, const std::string& topic, uint32_t queue_size,
                                 const std::function<void(const Message&)>& callback)
{
  const boost::function<void(const topic_tools::ShapeShifter::ConstPtr&)> read =
      [topic, callback](const topic_tools::ShapeShifter::ConstPtr& received)
  {
    try
    {
      callback(readMessage<Message>(*received));
    }
    catch (const InvalidInput& e)
    {
      ROS_WARN_STREAM_THROTTLE(10.0, "ignored a message on " << topic << ": " << e.what());
    }
  };
  return node.subscribe<topic_tools::ShapeShifter>(topic, queue_size, read);
}
}  // namespace devo_evo
