#include "devo_evo/farm/farm.h"

namespace devo_evo
{
namespace
{
std::string nameOf(WorkerState state)
{
  switch (state)
  {
    case WorkerState::CONNECTING:
      return "connecting";
    case WorkerState::IDLE:
      return "idle";
    case WorkerState::WORKING:
      return "working";
    case WorkerState::LATE:
      return "late";
    case WorkerState::LOST:
      return "lost";
    case WorkerState::REFUSED:
      return "refused";
    case WorkerState::QUARANTINED:
      return "quarantined";
  }
  return "";
}
}  // namespace

std::string stateText(const WorkerStatus& worker)
{
  const bool fine = worker.state == WorkerState::CONNECTING || worker.state == WorkerState::IDLE ||
                    worker.state == WorkerState::WORKING;
  return nameOf(worker.state) + (fine || worker.reason.empty() ? "" : ": " + worker.reason);
}
}  // namespace devo_evo
