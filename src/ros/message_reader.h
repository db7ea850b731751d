#pragma once

#include "devo_evo/soft_body/settings.h"
#include "devo_evo/soft_body/text.h"

#include <ros/message_traits.h>
#include <ros/serialization.h>

#include <string>
#include <vector>

namespace devo_evo
{
/// A stream to deserialise messages from that believes no length it reads: an array is made only if its elements can be
/// among the bytes that are left. roscpp's own stream makes the array first, so that a message of a few bytes can ask
/// for 32 GB of memory.
class MessageReader
{
public:
  MessageReader(uint8_t* bytes, uint32_t size) : bytes_(bytes, size) {}

  template <class Value>
  void next(Value& value)
  {
    if constexpr (ros::message_traits::IsMessage<Value>::value)
    {
      ros::serialization::Serializer<Value>::read(*this, value);
    }
    else
    {
      bytes_.next(value);
    }
  }

  template <class Element>
  void next(std::vector<Element>& array)
  {
    static const uint64_t smallest = ros::serialization::serializationLength(Element());  // its own arrays are empty
    uint32_t size = 0;
    bytes_.next(size);
    if (size * smallest > left())
    {
      throw InvalidInput("the message has an array of " + toText(int64_t{ size }) + " elements, of which at most " +
                         toText(static_cast<int64_t>(left() / smallest)) + " can follow");
    }
    array.resize(size);
    for (Element& element : array)
    {
      next(element);
    }
  }

  uint32_t left() { return bytes_.getLength(); }

private:
  ros::serialization::IStream bytes_;
};

/// The message that was received as these bytes. @throw InvalidInput if they are none.
template <class Message>
Message readMessage(const ros::SerializedMessage& received)
{
  const size_t header = static_cast<size_t>(received.message_start - received.buf.get());
  MessageReader reader(received.message_start, static_cast<uint32_t>(received.num_bytes - header));
  Message message;
  try
  {
    reader.next(message);
  }
  catch (const ros::serialization::StreamOverrunException&)
  {
    throw InvalidInput("the message ends too early");
  }
  if (reader.left() != 0)
  {
    throw InvalidInput("the message goes on for " + toText(int64_t{ reader.left() }) + " bytes after its end");
  }
  return message;
}
}  // namespace devo_evo
