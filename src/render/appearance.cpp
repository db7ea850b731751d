#include "devo_evo/render/appearance.h"

#include "render/body_kinds.h"

namespace devo_evo
{
Eigen::Quaterniond Surroundings::floorToWorld() const
{
  return Eigen::Quaterniond(Eigen::AngleAxisd(-slope, Eigen::Vector3d::UnitX()));
}

std::shared_ptr<const Appearance> makeAppearance(const BodySettings& body)
{
  body.validate();
  switch (body.kind)
  {
    case BodyKind::SOFT:
      return makeVoxelAppearance(body.soft);
    case BodyKind::RIGID:
      return makeQuadrupedAppearance(body.rigid);
  }
  throw InvalidInput("robots of this kind of body cannot be shown");
}
}  // namespace devo_evo
