// A request to simulate, as a simulator receives it, up to the first step of the robots' lives.

#include "fuzz/bodies.h"
#include "fuzz/input.h"
#include "fuzz/ros/received.h"
#include "ros/conversions.h"

devo_evo::fuzz::Refusal devo_evo::fuzz::handle(const uint8_t* data, size_t size)
{
  try
  {
    const auto request = readMessage<EvaluateGenomes::Request>(received(data, size));
    quarantineOf(request);
    const BodySettings settings = fromMsg(request.settings);
    for (const EvaluationRequest& robot : robotsOf(request, *makeBody(settings)))
    {
      beginLife(settings, robot.program);
    }
  }
  catch (const InvalidInput& e)
  {
    return e.what();
  }
  return std::nullopt;
}
