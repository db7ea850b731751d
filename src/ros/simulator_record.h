#pragma once

#include "devo_evo/farm/farm.h"
#include "ros/simulator_farm.h"

#include <devo_evo/SimulatorAnnouncement.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace devo_evo
{
/// What a farm knows of one simulator.
struct SimulatorRecord
{
  using Clock = std::chrono::steady_clock;

  SimulatorAnnouncement announcement;  // the latest
  WorkerState state = WorkerState::LOST;
  std::string reason;    // why it is late, lost, refused or quarantined; stays when it is back
  uint64_t session = 0;  // which thread serves it; what earlier ones still bring is void
  std::shared_ptr<SimulatorConnection> connection;
  std::optional<Clock::time_point> call_began;  // the call that runs
  Clock::time_point last_heard;
  Clock::time_point retry_at;  // no new session before
  bool told = false;           // that it is refused or quarantined
  int failures = 0;            // in a row
  int64_t evaluations = 0;
  int64_t checked = 0;
  int64_t losses = 0;

  const std::string& name() const { return announcement.name; }

  /// Whether it takes work.
  bool usable() const { return devo_evo::usable(state); }

  /// Whether a session with it goes on.
  bool served() const { return usable() || state == WorkerState::CONNECTING; }

  /// Whether it is not to be asked as long as it is the same process.
  bool rejected() const { return state == WorkerState::REFUSED || state == WorkerState::QUARANTINED; }

  WorkerStatus status() const;
};

bool sameProcess(const SimulatorAnnouncement& a, const SimulatorAnnouncement& b);

/// Name, host, process and instruction set, for people.
std::string describe(const SimulatorAnnouncement& simulator);

/// Why a simulator of another engine is refused.
std::string engineMismatch(const SimulatorAnnouncement& simulator, const std::string& kind, uint64_t own_fingerprint);
}  // namespace devo_evo
