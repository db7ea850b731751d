#pragma once

#include "kernel.h"

#include "devo_evo/soft_body/lattice.h"
#include "devo_evo/soft_body/settings.h"

#include <cstdint>
#include <vector>

namespace devo_evo
{
/// The constants of a batch, computed once from the settings, with the arrays that BodyModel points to.
class BodyConstants
{
public:
  BodyConstants(const SoftBodySettings& settings, const Lattice& lattice);
  BodyConstants(const BodyConstants&) = delete;
  BodyConstants& operator=(const BodyConstants&) = delete;

  const BodyModel& model() const { return model_; }

private:
  std::vector<uint8_t> upper_neighbours_;
  std::vector<uint8_t> in_top_layer_;
  BodyModel model_;
};

/// What the kernel is told of time (docs/physics.md 5) for the step that begins at `time` of the simulator [s].
StepClock clockOf(const SoftBodySettings& settings, int64_t completed_steps, double time);
}  // namespace devo_evo
