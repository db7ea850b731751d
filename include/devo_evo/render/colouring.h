#pragma once

#include "devo_evo/render/life_playback.h"

#include <string>
#include <vector>

namespace devo_evo
{
/// What the colour of a part tells: of a voxel, L being voxel_size, or of a leg, R being rigid_leg_range.
enum class Colouring
{
  RESTING_LENGTH,         ///< without actuation, as in the paper's Fig. 1: jet(length / 1.5 L - 0.1), jet(length / R)
  REMAINING_DEVELOPMENT,  ///< as in the paper's Fig. 2: jet(remaining / 1.5 L + 0.5), jet(remaining / 2 R + 0.5): blue
                          ///< will shrink, red will grow
  PHASE,                  ///< offset of actuation, on a circle of hues: one turn a cycle, phase 0 is cyan
  PRESENT_LENGTH          ///< as it is now, like RESTING_LENGTH
};

/// "resting_length", "remaining_development", "phase" or "present_length".
std::string toString(Colouring colouring);
Colouring parseColouring(const std::string& name);  ///< @throw InvalidInput

/// A colour by its parts, each from 0 to 1.
struct Colour
{
  float red;
  float green;
  float blue;
};

/// The scale of the authors' viewer: blue at 0, cyan, green at 1/2, yellow, red at 1, linear between; outside as at the
/// nearer end.
Colour jet(double value);

/// Colour of a hue on the circle [turns]: red at 0 and 1, green at 1/3, blue at 2/3.
Colour hue(double turns);

/// The colour of a part. @param resting, present, remaining its lengths on the scale of jet().
Colour colourOfPart(const ShownPart& part, Colouring colouring, double resting, double present, double remaining);
}  // namespace devo_evo
