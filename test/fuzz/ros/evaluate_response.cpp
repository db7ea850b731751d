// A simulator's answer on two robots, as the farm receives it. The first byte chooses the settings.

#include "fuzz/input.h"
#include "fuzz/ros/received.h"
#include "ros/conversions.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  using namespace devo_evo;
  if (size == 0)
  {
    return 0;
  }
  SoftBodySettings settings;
  settings.lifetime = data[0] % 2 == 0 ? 1.25 : 0.001;
  const std::shared_ptr<const Body> body = makeSoftBody(settings);
  const std::vector<EvaluationRequest> robots = { { 1, 0, {} }, { 1, 7, {} } };
  try
  {
    const auto response = readMessage<EvaluateGenomes::Response>(fuzz::received(data + 1, size - 1));
    for (const Evaluation& evaluation : evaluationsOf(response, robots, *body))
    {
      // Whatever is accepted can be passed on: it is accepted again, and velocity telemetry can be made of it.
      fromMsg(toMsg(evaluation, 1, 0, *body), *body);
      const VelocityTelemetry telemetry = telemetryOf(robots[0], evaluation, *body, "/simulator");
      fuzz::require(telemetry.window_end.size() == telemetry.velocity.size());
    }
  }
  catch (const InvalidInput&)
  {
  }
  return 0;
}
