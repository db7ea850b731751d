// A simulator's answer on the two robots that asked for it, as the farm receives it. The first byte chooses the body.

#include "fuzz/input.h"
#include "fuzz/ros/asked_robots.h"
#include "fuzz/ros/received.h"
#include "ros/conversions.h"

devo_evo::fuzz::Refusal devo_evo::fuzz::handle(const uint8_t* data, size_t size)
{
  if (size == 0)
  {
    return "there is no first byte";
  }
  const std::shared_ptr<const Body> body = makeBody(askedBody(data[0]));
  const std::vector<EvaluationRequest> robots = askedRobots();
  try
  {
    const auto response = readMessage<EvaluateGenomes::Response>(received(data + 1, size - 1));
    for (const Evaluation& evaluation : evaluationsOf(response, robots, *body))
    {
      // Whatever is accepted can be passed on: it is accepted again, and velocity telemetry can be made of it.
      fromMsg(toMsg(evaluation, 1, 0, *body), *body);
      const VelocityTelemetry telemetry = telemetryOf(robots[0], evaluation, *body, "/simulator");
      require(telemetry.window_end.size() == telemetry.velocity.size());
    }
  }
  catch (const InvalidInput& e)
  {
    return e.what();
  }
  return std::nullopt;
}
