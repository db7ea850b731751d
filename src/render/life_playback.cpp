#include "devo_evo/render/life_playback.h"

#include "devo_evo/soft_body/simulation.h"
#include "render/body_kinds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace devo_evo
{
namespace
{
bool isFinite(const ShownPart& part)
{
  return part.position.allFinite() && part.orientation.coeffs().allFinite() && std::isfinite(part.present_length) &&
         std::isfinite(part.resting_length);
}
}  // namespace

bool RobotFrame::finite() const
{
  return center_of_mass.allFinite() && orientation.coeffs().allFinite() &&
         std::all_of(parts.begin(), parts.end(), isFinite);
}

std::unique_ptr<LivingRobot> makeLivingRobot(const BodySettings& body, const DevelopmentalProgram& program)
{
  switch (body.kind)
  {
    case BodyKind::SOFT:
      return makeLivingVoxels(body.soft, program);
    case BodyKind::RIGID:
      return makeLivingQuadruped(body.rigid, program);
  }
  throw InvalidInput("robots of this kind of body cannot be shown");
}

bool LifePlayback::advanceTo(double time_since_birth_s, const std::atomic<bool>* stop)
{
  constexpr int64_t steps_between_looks = 64;
  for (int64_t step = 0; time() <= time_since_birth_s && !finished(); ++step)
  {
    if (stop != nullptr && step % steps_between_looks == 0 && *stop)
    {
      throw EvaluationAbandoned();
    }
    robot_->step();
  }
  return time() > time_since_birth_s && !diverged();
}

void LifePlayback::finish(const std::atomic<bool>* stop)
{
  advanceTo(std::numeric_limits<double>::infinity(), stop);
}
}  // namespace devo_evo
