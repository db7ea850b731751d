#include "ros/simulator_farm.h"

#include "ros/simulator_farm_state.h"

#include <system_error>
#include <utility>

namespace devo_evo
{
SimulatorFarm::SimulatorFarm(const SimulatorFarmSettings& settings, SimulatorConnector connector, Referee referee)
  : connector_(std::move(connector))
  , state_(std::make_shared<State>(settings, std::move(referee)))
  , watchdog_([state = state_] { state->watch(); })
  , referee_([state = state_] { state->judgeDisputes(); })
{
}

SimulatorFarm::~SimulatorFarm()
{
  close();
}

bool SimulatorFarm::close()
{
  state_->beginClosing();
  for (std::thread* const thread : { &watchdog_, &referee_ })
  {
    if (thread->joinable())
    {
      thread->join();
    }
  }
  return state_->waitForThreads();
}

void SimulatorFarm::heardFrom(const SimulatorAnnouncement& announcement)
{
  const std::optional<SimulatorSession> session = state_->announced(announcement, connector_);
  if (!session)
  {
    return;
  }
  try
  {
    std::thread([state = state_, session = *session] { state->serve(session); }).detach();
  }
  catch (const std::system_error& e)
  {
    state_->abandon(*session, std::string("no thread for it: ") + e.what());
  }
}

void SimulatorFarm::submit(std::vector<EvaluationRequest> requests)
{
  for (const EvaluationRequest& request : requests)
  {
    state_->body().validate(request.program);
  }
  state_->submit(std::move(requests));
}

std::vector<EvaluationResult> SimulatorFarm::collect(std::chrono::milliseconds timeout)
{
  return state_->collect(timeout);
}

std::vector<WorkerStatus> SimulatorFarm::status() const
{
  return state_->status();
}
}  // namespace devo_evo
