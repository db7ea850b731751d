#include "devo_evo/render/life_playback.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace devo_evo
{
namespace
{
constexpr int64_t STEPS_BETWEEN_LOOKS = 64;
constexpr double SIZE_RANGE = 0.75;  // resting length = L (1 + 0.75 gene)

bool isFinite(const ShownVoxel& voxel)
{
  return voxel.position.allFinite() && voxel.orientation.coeffs().allFinite() && std::isfinite(voxel.present_length) &&
         std::isfinite(voxel.resting_length);
}
}  // namespace

bool RobotFrame::finite() const
{
  return center_of_mass.allFinite() && orientation.coeffs().allFinite() &&
         std::all_of(voxels.begin(), voxels.end(), isFinite);
}

// One robot is simulated fastest by the kernel for one.
LifePlayback::LifePlayback(const SoftBodySettings& settings, const DevelopmentalProgram& program)
  : settings_(settings), program_(program), simulation_(makeSimulation(settings, { program }, InstructionSet::SCALAR))
{
}

bool LifePlayback::advanceTo(double time_since_birth_s, const std::atomic<bool>* stop)
{
  while (time() <= time_since_birth_s && !simulation_->finished())
  {
    if (stop != nullptr && simulation_->stepCount() % STEPS_BETWEEN_LOOKS == 0 && *stop)
    {
      throw EvaluationAbandoned();
    }
    simulation_->step();
  }
  return time() > time_since_birth_s && !diverged();
}

void LifePlayback::finish(const std::atomic<bool>* stop)
{
  advanceTo(std::numeric_limits<double>::infinity(), stop);
}

RobotFrame LifePlayback::frame() const
{
  RobotFrame frame;
  frame.time_since_birth = time();
  frame.center_of_mass = simulation_->centerOfMass(0);
  frame.orientation = simulation_->meanOrientation(0);
  const double life_fraction = std::clamp(time() / settings_.lifetime, 0.0, 1.0);
  for (int voxel = 0; voxel < settings_.voxelCount(); ++voxel)
  {
    const auto i = static_cast<size_t>(voxel);
    const VoxelState state = simulation_->voxel(0, voxel);
    const double resting_length = simulation_->restingLength(0, voxel);
    const double final_length = settings_.voxel_size * (1.0 + SIZE_RANGE * program_.morphology_final[i]);
    frame.voxels.push_back(
        { state.position, state.orientation, state.scale, resting_length, final_length - resting_length,
          program_.control_initial[i] + life_fraction * (program_.control_final[i] - program_.control_initial[i]) });
  }
  return frame;
}
}  // namespace devo_evo
