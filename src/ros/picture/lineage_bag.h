#pragma once

#include "devo_evo/archive/archive.h"
#include "devo_evo/picture/lineage.h"
#include "devo_evo/render/colouring.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace devo_evo
{
/// How a lineage is recorded.
struct LineageBagOptions
{
  int64_t count = 0;   ///< how many individuals, evenly spaced, always with founder and last; 0: all
  double rate = 25.0;  ///< pictures per second of life, 1 to 200 [1/s]
  double pause = 1.0;  ///< between lives, 0.1 to 60 [s]
  Colouring colouring = Colouring::RESTING_LENGTH;

  /// @throw InvalidInput naming the field, its value and its range.
  void validate() const;
};

/// Told before each life how many of how many are recorded.
using LineageProgress = std::function<void(size_t done, size_t total)>;

/// Simulates the individuals of a lineage again, founder first, and records their lives. Time begins at 1 s and never
/// goes back. Topics, in the namespace /lineage: `individual` (EvolvedRobot) at each birth, `robot` and `floor`
/// (MarkerArray), `velocity` (VelocityTelemetry) at each end of life; and /tf with `lineage/robot` and `lineage/follow`
/// in `world`, whose positions are exact, at birth and end of life too (docs/nodes.md).
/// @param path of the bag; it appears there once it is whole.
/// @throw InvalidInput if a genome is not known any more; std::runtime_error if the bag cannot be written, or if a
/// robot does not do again what was recorded of it.
void writeLineageBag(const Archive& archive, const Lineage& lineage, const LineageBagOptions& options,
                     const std::string& path, const LineageProgress& progress);
}  // namespace devo_evo
