// A simulator's announcement, as the evolver receives it.

#include "fuzz/input.h"
#include "fuzz/ros/received.h"
#include "ros/conversions.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  using namespace devo_evo;
  try
  {
    const auto announcement = readMessage<SimulatorAnnouncement>(fuzz::received(data, size));
    validate(announcement);
    fuzz::require(announcement.name.front() == '/' && announcement.name.size() <= 255);
  }
  catch (const InvalidInput&)
  {
  }
  return 0;
}
