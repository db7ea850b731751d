#pragma once

#include "devo_evo/render/appearance.h"
#include "devo_evo/render/life_playback.h"

#include <memory>

namespace devo_evo
{
// What there is of each kind of body.

std::unique_ptr<LivingRobot> makeLivingVoxels(const SoftBodySettings& settings, const DevelopmentalProgram& program);
std::unique_ptr<LivingRobot> makeLivingQuadruped(const RigidBodySettings& settings,
                                                 const DevelopmentalProgram& program);

std::shared_ptr<const Appearance> makeVoxelAppearance(const SoftBodySettings& settings);
std::shared_ptr<const Appearance> makeQuadrupedAppearance(const RigidBodySettings& settings);
}  // namespace devo_evo
