#include "devo_evo/bodies/rigid.h"
#include "devo_evo/rigid_body/quadruped.h"
#include "render/body_kinds.h"

#include <algorithm>
#include <cmath>

namespace devo_evo
{
namespace
{
constexpr double TWO_PI = 6.283185307179586;

class LivingQuadruped : public LivingRobot
{
public:
  LivingQuadruped(const RigidBodySettings& settings, const QuadrupedProgram& program)
    : settings_(settings), program_(program), simulation_(settings, program)
  {
  }

  void step() override { simulation_.step(); }
  bool finished() const override { return simulation_.finished(); }
  bool diverged() const override { return simulation_.evaluation().failed_step.has_value(); }
  double timeSinceBirth() const override { return simulation_.time(); }
  Eigen::Vector3d centerOfMass() const override { return simulation_.abdomen().position; }
  Evaluation evaluation() const override { return toEvaluation(simulation_.evaluation(), settings_); }

  RobotFrame frame() const override
  {
    const PartState abdomen = simulation_.abdomen();
    RobotFrame frame;
    frame.time_since_birth = timeSinceBirth();
    frame.center_of_mass = abdomen.position;
    frame.orientation = abdomen.orientation;
    const double size = 2.0 * settings_.abdomen_radius;
    frame.parts.push_back({ abdomen.position, abdomen.orientation, size, size, 0.0, 0.0 });
    for (size_t leg = 0; leg < LEG_COUNT; ++leg)
    {
      frame.parts.push_back(shownLeg(leg));
    }
    return frame;
  }

private:
  ShownPart shownLeg(size_t leg) const
  {
    const double age = std::clamp(timeSinceBirth() / settings_.lifetime, 0.0, 1.0);
    const auto protrusion = [&](double length) { return settings_.leg_residual + settings_.leg_range * length; };
    const PartState rod = simulation_.leg(leg);
    const double wanted = program_.legLength(leg, age);
    const double final_length = protrusion(program_.leg_length_final[leg]);
    // The generators are sine and cosine: w0 sin + w1 cos is a sine ahead by this phase.
    return { rod.position,
             rod.orientation,
             protrusion(simulation_.legLength(leg)),
             protrusion(wanted),
             final_length - protrusion(wanted),
             std::atan2(program_.weight(leg, 1, age), program_.weight(leg, 0, age)) / TWO_PI };
  }

  const RigidBodySettings settings_;
  const QuadrupedProgram program_;
  QuadrupedSimulation simulation_;
};
}  // namespace

std::unique_ptr<LivingRobot> makeLivingQuadruped(const RigidBodySettings& settings, const DevelopmentalProgram& program)
{
  makeRigidBody(settings)->validate(program);
  return std::make_unique<LivingQuadruped>(settings, toQuadruped(program));
}
}  // namespace devo_evo
