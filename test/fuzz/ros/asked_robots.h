#pragma once

#include "devo_evo/bodies/bodies.h"
#include "devo_evo/farm/farm.h"
#include "fuzz/bodies.h"

#include <cstdint>
#include <vector>

namespace devo_evo::fuzz
{
// What the answers of the target evaluate_response answer.

constexpr uint8_t LONG_LIFE = 0;   ///< with velocities
constexpr uint8_t SHORT_LIFE = 1;  ///< too short for one
constexpr uint8_t RIGID_BODY = 2;

inline BodySettings askedBody(uint8_t choice)
{
  if ((choice & RIGID_BODY) != 0)
  {
    return BodySettings(shortLivedQuadruped());
  }
  SoftBodySettings settings = twoVoxels();
  settings.lifetime = (choice & SHORT_LIFE) != 0 ? 0.001 : settings.lifetime;
  return BodySettings(settings);
}

inline std::vector<EvaluationRequest> askedRobots()
{
  return { { 1, 0, {} }, { 1, 7, {} } };
}
}  // namespace devo_evo::fuzz
