#pragma once

#include "devo_evo/soft_body/developmental_program.h"
#include "devo_evo/soft_body/lattice.h"

#include "soft_body/batch_memory.h"
#include "soft_body/body_model.h"
#include "soft_body/collision_list.h"
#include "soft_body/kernel.h"

#include <cstdint>
#include <vector>

namespace devo_evo
{
/// What a kernel is given to advance a batch by one step.
struct Moment
{
  StepClock clock;
  BatchMemory memory;
  std::vector<CollisionPair> pairs;
};

/// Robots that live as in a Simulation, without its measures, so that kernels can be measured alone.
class LivingBatch
{
public:
  /// @param robots one to kernel.lanes. @param listings how many times collisions are listed, to tell what that takes.
  LivingBatch(const SoftBodySettings& settings, const std::vector<DevelopmentalProgram>& robots, const Kernel& kernel,
              int listings = 1);
  LivingBatch(const LivingBatch&) = delete;
  LivingBatch& operator=(const LivingBatch&) = delete;

  bool finished() const { return time_ > SETTLING_TIME + settings_.lifetime; }
  double time() const { return time_; }
  int64_t stepCount() const { return step_count_; }

  /// @param moments if given, gets what the kernel is given appended.
  void step(std::vector<Moment>* moments = nullptr);

  /// Gives the kernel's arrays the values they had in a moment of this or another batch of the same body and number of
  /// lanes. The moment must outlive their use.
  void restore(const Moment& moment);

  const BodyModel& model() const { return constants_.model(); }
  BatchState& state() { return state_; }
  const BatchMemory& memory() const { return memory_; }

private:
  double& at(int lane, int voxel, int field);
  void placeRobot(int lane, const DevelopmentalProgram& program);
  void list();
  StepClock clock() const;

  const SoftBodySettings settings_;
  const Kernel& kernel_;
  const Lattice lattice_;
  const BodyConstants constants_;
  std::vector<CollisionList> collisions_;
  BatchMemory memory_;
  BatchState state_{};
  int64_t step_count_ = 0;
  double time_ = 0.0;
};
}  // namespace devo_evo
