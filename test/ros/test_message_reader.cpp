#include "ros/message_reader.h"

#include <devo_evo/EvaluateGenomes.h>
#include <devo_evo/SimulatorAnnouncement.h>

#include <gtest/gtest.h>

#include <cstring>

namespace devo_evo
{
namespace
{
EvaluateGenomes::Request someRequest()
{
  EvaluateGenomes::Request request;
  request.engine_fingerprint = 0x123456789;
  request.settings.names = { "body", "lifetime" };
  request.settings.values = { "soft", "2.5" };
  request.genomes.resize(2);
  request.genomes[1].arrays.resize(1);
  request.genomes[1].arrays[0].name = "phase_final";
  request.genomes[1].arrays[0].values = { 0.25, -0.5 };
  request.trial = { 1, 2 };
  request.id = { 3, 4 };
  return request;
}

/// What roscpp sends of a message and its receiver gets: the bytes after the length.
template <class Message>
ros::SerializedMessage received(const Message& message)
{
  ros::SerializedMessage sent = ros::serialization::serializeMessage(message);
  ros::SerializedMessage received;
  received.num_bytes = sent.num_bytes - sizeof(uint32_t);
  received.buf.reset(new uint8_t[received.num_bytes]);
  std::memcpy(received.buf.get(), sent.message_start, received.num_bytes);
  received.message_start = received.buf.get();
  return received;
}

std::string complaint(const ros::SerializedMessage& received)
{
  try
  {
    readMessage<EvaluateGenomes::Request>(received);
  }
  catch (const InvalidInput& e)
  {
    return e.what();
  }
  return "";
}

/// Where in a request with one genome the length of the list of genomes stands: behind fingerprint and settings.
size_t placeOfGenomeCount()
{
  return sizeof(uint64_t) + ros::serialization::serializationLength(EvaluationSettings());
}

TEST(MessageReader, ReadsWhatRoscppWrote)
{
  const auto back = readMessage<EvaluateGenomes::Request>(received(someRequest()));
  EXPECT_EQ(back.engine_fingerprint, 0x123456789U);
  EXPECT_EQ(back.settings.names, (std::vector<std::string>{ "body", "lifetime" }));
  EXPECT_EQ(back.settings.values, (std::vector<std::string>{ "soft", "2.5" }));
  ASSERT_EQ(back.genomes.size(), 2U);
  EXPECT_EQ(back.genomes[1].arrays.at(0).name, "phase_final");
  EXPECT_EQ(back.genomes[1].arrays.at(0).values, (std::vector<double>{ 0.25, -0.5 }));
  EXPECT_EQ(back.trial, (std::vector<int64_t>{ 1, 2 }));
  EXPECT_EQ(back.id, (std::vector<int64_t>{ 3, 4 }));
}

TEST(MessageReader, ReadsTextAndStamps)
{
  SimulatorAnnouncement announcement;
  announcement.header.stamp = ros::Time(17, 4);
  announcement.name = "/simulator";
  announcement.busy = true;
  const auto back = readMessage<SimulatorAnnouncement>(received(announcement));
  EXPECT_EQ(back.header.stamp, ros::Time(17, 4));
  EXPECT_EQ(back.name, "/simulator");
  EXPECT_TRUE(back.busy);
}

TEST(MessageReader, RefusesArraysThatCannotBeInTheMessage)
{
  EvaluateGenomes::Request request;
  for (const uint32_t claimed : { 2U, 1000U, 0x20000001U, 0xffffffffU })
  {
    const ros::SerializedMessage message = received(request);
    std::memcpy(message.buf.get() + placeOfGenomeCount(), &claimed, sizeof(claimed));
    // A genome takes 12 bytes, the lengths of its name and two lists; as many follow, the lengths of trial, id and
    // quarantine.
    EXPECT_EQ(complaint(message),
              "the message has an array of " + std::to_string(claimed) + " elements, of which at most 1 can follow");
  }
}

TEST(MessageReader, RefusesMessagesThatEndTooEarlyOrGoOn)
{
  const ros::SerializedMessage whole = received(someRequest());
  EXPECT_EQ(complaint(whole), "");
  for (size_t size = 0; size < whole.num_bytes; ++size)
  {
    ros::SerializedMessage part = whole;
    part.num_bytes = size;
    EXPECT_NE(complaint(part), "") << size;
  }
  ros::SerializedMessage longer;
  longer.num_bytes = whole.num_bytes + 3;
  longer.buf.reset(new uint8_t[longer.num_bytes]());
  std::memcpy(longer.buf.get(), whole.buf.get(), whole.num_bytes);
  longer.message_start = longer.buf.get();
  EXPECT_EQ(complaint(longer), "the message goes on for 3 bytes after its end");
}
}  // namespace
}  // namespace devo_evo
