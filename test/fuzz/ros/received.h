#pragma once

#include "ros/message_reader.h"

#include <algorithm>

namespace devo_evo::fuzz
{
/// An input as roscpp hands over what came from the network.
inline ros::SerializedMessage received(const uint8_t* data, size_t size)
{
  ros::SerializedMessage message(boost::shared_array<uint8_t>(new uint8_t[size]), size);
  std::copy_n(data, size, message.buf.get());
  message.message_start = message.buf.get();
  return message;
}
}  // namespace devo_evo::fuzz
