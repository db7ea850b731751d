// A simulator's announcement, as the evolver receives it.

#include "fuzz/input.h"
#include "fuzz/ros/received.h"
#include "ros/conversions.h"

devo_evo::fuzz::Refusal devo_evo::fuzz::handle(const uint8_t* data, size_t size)
{
  try
  {
    const auto announcement = readMessage<SimulatorAnnouncement>(received(data, size));
    validate(announcement);
    require(announcement.name.front() == '/' && announcement.name.size() <= 255);
  }
  catch (const InvalidInput& e)
  {
    return e.what();
  }
  return std::nullopt;
}
