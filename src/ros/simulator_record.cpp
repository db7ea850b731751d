#include "ros/simulator_record.h"

#include "devo_evo/soft_body/text.h"
#include "ros/conversions.h"

namespace devo_evo
{
WorkerStatus SimulatorRecord::status() const
{
  return { announcement.name,
           announcement.host,
           state,
           reason,
           evaluations,
           checked,
           losses,
           announcement.processor,
           announcement.instruction_set,
           announcement.version };
}

bool sameProcess(const SimulatorAnnouncement& a, const SimulatorAnnouncement& b)
{
  return a.service == b.service && a.host == b.host && a.pid == b.pid;
}

std::string describe(const SimulatorAnnouncement& simulator)
{
  return simulator.name + " (host " + simulator.host + ", process " + toText(static_cast<int64_t>(simulator.pid)) +
         ", " + simulator.instruction_set + ")";
}

std::string engineMismatch(const SimulatorAnnouncement& simulator, const std::string& kind, uint64_t own_fingerprint)
{
  return "its engine fingerprint for " + kind + " bodies is " + hashToString(fingerprintFor(kind, simulator)) +
         ", that of this evolver is " + hashToString(own_fingerprint) + "; its version is " + simulator.version;
}
}  // namespace devo_evo
