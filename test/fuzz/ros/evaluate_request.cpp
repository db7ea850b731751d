// A request to simulate, as a simulator receives it, up to the first step of the robots' lives.

#include "devo_evo/soft_body/simulation.h"
#include "fuzz/input.h"
#include "fuzz/ros/received.h"
#include "ros/conversions.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  using namespace devo_evo;
  try
  {
    const auto request = readMessage<EvaluateGenomes::Request>(fuzz::received(data, size));
    quarantineOf(request);
    const BodySettings settings = fromMsg(request.settings);
    for (const EvaluationRequest& robot : robotsOf(request, *makeBody(settings)))
    {
      if (settings.kind == BodyKind::SOFT)
      {
        makeSimulation(settings.soft, { robot.program }, InstructionSet::SCALAR)->step();
      }
    }
  }
  catch (const InvalidInput&)
  {
  }
  return 0;
}
