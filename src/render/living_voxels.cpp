#include "devo_evo/soft_body/simulation.h"
#include "render/body_kinds.h"

#include <algorithm>

namespace devo_evo
{
namespace
{
constexpr double SIZE_RANGE = 0.75;  // resting length = L (1 + 0.75 gene)

class LivingVoxels : public LivingRobot
{
public:
  // One robot is simulated fastest by the kernel for one.
  LivingVoxels(const SoftBodySettings& settings, const DevelopmentalProgram& program)
    : settings_(settings), program_(program), simulation_(makeSimulation(settings, { program }, InstructionSet::SCALAR))
  {
  }

  void step() override { simulation_->step(); }
  bool finished() const override { return simulation_->finished(); }
  bool diverged() const override { return simulation_->diverged(0); }
  double timeSinceBirth() const override { return simulation_->time() - SETTLING_TIME; }
  Eigen::Vector3d centerOfMass() const override { return simulation_->centerOfMass(0); }
  Evaluation evaluation() const override { return simulation_->evaluation(0); }

  RobotFrame frame() const override
  {
    RobotFrame frame;
    frame.time_since_birth = timeSinceBirth();
    frame.center_of_mass = centerOfMass();
    frame.orientation = simulation_->meanOrientation(0);
    const double life_fraction = std::clamp(timeSinceBirth() / settings_.lifetime, 0.0, 1.0);
    for (int voxel = 0; voxel < settings_.voxelCount(); ++voxel)
    {
      const auto i = static_cast<size_t>(voxel);
      const VoxelState state = simulation_->voxel(0, voxel);
      const double resting_length = simulation_->restingLength(0, voxel);
      const double final_length = settings_.voxel_size * (1.0 + SIZE_RANGE * program_.morphology_final[i]);
      const double phase = program_.control_initial[i];
      frame.parts.push_back({ state.position, state.orientation, state.scale, resting_length,
                              final_length - resting_length,
                              phase + life_fraction * (program_.control_final[i] - phase) });
    }
    return frame;
  }

private:
  const SoftBodySettings settings_;
  const DevelopmentalProgram program_;
  const std::unique_ptr<Simulation> simulation_;
};
}  // namespace

std::unique_ptr<LivingRobot> makeLivingVoxels(const SoftBodySettings& settings, const DevelopmentalProgram& program)
{
  return std::make_unique<LivingVoxels>(settings, program);
}
}  // namespace devo_evo
