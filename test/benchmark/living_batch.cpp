#include "benchmark/living_batch.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace devo_evo
{
LivingBatch::LivingBatch(const SoftBodySettings& settings, const std::vector<DevelopmentalProgram>& robots,
                         const Kernel& kernel, int listings)
  : settings_(settings)
  , kernel_(kernel)
  , lattice_(settings)
  , constants_(settings, lattice_)
  , collisions_(static_cast<size_t>(listings),
                CollisionList(lattice_, settings.voxel_size, kernel.lanes, static_cast<int>(robots.size())))
  , memory_(constants_.model(), kernel.lanes)
{
  memory_.lendTo(state_);
  const auto lanes = static_cast<size_t>(kernel.lanes);
  for (size_t lane = 0; lane < lanes; ++lane)
  {
    placeRobot(static_cast<int>(lane), robots[std::min(lane, robots.size() - 1)]);
  }
}

void LivingBatch::step(std::vector<Moment>* moments)
{
  list();
  const StepClock now = clock();
  if (moments != nullptr)
  {
    moments->push_back({ now, memory_, collisions_.front().pairs() });
  }
  kernel_.step(model(), now, state_);
  if (state_.diverged != 0)
  {
    throw std::runtime_error("a robot that is measured diverges: take others");
  }
  time_ += model().dt;
  ++step_count_;
}

void LivingBatch::restore(const Moment& moment)
{
  memory_ = moment.memory;
  memory_.lendTo(state_);
  state_.collision_pairs = moment.pairs.data();
  state_.collision_pair_count = static_cast<int>(moment.pairs.size());
}

double& LivingBatch::at(int lane, int voxel, int field)
{
  return state_.voxels[(voxel * VOXEL_FIELDS + field) * kernel_.lanes + lane];
}

void LivingBatch::placeRobot(int lane, const DevelopmentalProgram& program)
{
  const double L = settings_.voxel_size;
  const auto length = [L](double gene) { return L * (1.0 + 0.75 * gene); };
  for (int voxel = 0; voxel < lattice_.voxelCount(); ++voxel)
  {
    const auto i = static_cast<size_t>(voxel);
    const std::array<int, 3> place = lattice_.coordinates(voxel);
    for (int axis = 0; axis < 3; ++axis)
    {
      at(lane, voxel, POSITION + axis) = (place[static_cast<size_t>(axis)] + 0.5) * L;
    }
    at(lane, voxel, ORIENTATION) = 1.0;
    at(lane, voxel, SCALE) = L;
    at(lane, voxel, SIZE_AT_BIRTH) = length(program.morphology_initial[i]);
    at(lane, voxel, SIZE_CHANGE) = length(program.morphology_final[i]) - length(program.morphology_initial[i]);
    at(lane, voxel, PHASE_AT_BIRTH) = program.control_initial[i];
    at(lane, voxel, PHASE_CHANGE) = program.control_final[i] - program.control_initial[i];
  }
}

void LivingBatch::list()
{
  for (CollisionList& each : collisions_)
  {
    each.update(state_.voxels, state_.max_speed_squared, model().dt);
  }
  state_.collision_pairs = collisions_.front().pairs().data();
  state_.collision_pair_count = static_cast<int>(collisions_.front().pairs().size());
}

StepClock LivingBatch::clock() const
{
  return clockOf(settings_, step_count_, time_);
}
}  // namespace devo_evo
