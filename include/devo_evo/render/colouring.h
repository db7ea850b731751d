#pragma once

#include "devo_evo/render/life_playback.h"

#include <string>
#include <vector>

namespace devo_evo
{
/// What the colour of a voxel tells. L: voxel_size.
enum class Colouring
{
  RESTING_LENGTH,         ///< without actuation, as in the paper's Fig. 1: jet(length / 1.5 L - 0.1)
  REMAINING_DEVELOPMENT,  ///< as in the paper's Fig. 2: jet(remaining / 1.5 L + 0.5): blue will shrink, red will grow
  PHASE,                  ///< offset of actuation, on a circle of hues: one turn a cycle, phase 0 is cyan
  PRESENT_LENGTH          ///< with actuation: jet(length / 1.5 L - 0.1)
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

Colour colourOf(const ShownVoxel& voxel, Colouring colouring, double voxel_size);
}  // namespace devo_evo
