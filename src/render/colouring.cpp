#include "devo_evo/render/colouring.h"

#include "devo_evo/soft_body/settings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace devo_evo
{
namespace
{
const std::array<std::pair<Colouring, const char*>, 4> NAMES = { {
    { Colouring::RESTING_LENGTH, "resting_length" },
    { Colouring::REMAINING_DEVELOPMENT, "remaining_development" },
    { Colouring::PHASE, "phase" },
    { Colouring::PRESENT_LENGTH, "present_length" },
} };

/// How strong one part of a colour is: 1 from low to high, falling to 0 within `fall` on both sides.
float plateau(double value, double low, double high, double fall)
{
  return static_cast<float>(std::clamp(std::min(value - low, high - value) / fall + 1.0, 0.0, 1.0));
}
}  // namespace

std::string toString(Colouring colouring)
{
  return std::find_if(NAMES.begin(), NAMES.end(), [&](const auto& entry) { return entry.first == colouring; })->second;
}

Colouring parseColouring(const std::string& name)
{
  const auto found = std::find_if(NAMES.begin(), NAMES.end(), [&](const auto& entry) { return entry.second == name; });
  if (found == NAMES.end())
  {
    throw InvalidInput("colour is \"" + name +
                       "\"; it must be resting_length, remaining_development, phase or present_length");
  }
  return found->first;
}

Colour jet(double value)
{
  const double v = std::clamp(value, 0.0, 1.0);
  return { plateau(v, 0.75, 1.25, 0.25), plateau(v, 0.25, 0.75, 0.25), plateau(v, -0.25, 0.25, 0.25) };
}

Colour hue(double turns)
{
  const double sixths = 6.0 * (turns - std::floor(turns));
  const auto part = [](double distance) { return static_cast<float>(std::clamp(2.0 - distance, 0.0, 1.0)); };
  return { part(std::min(sixths, 6.0 - sixths)), part(std::abs(sixths - 2.0)), part(std::abs(sixths - 4.0)) };
}

Colour colourOfPart(const ShownPart& part, Colouring colouring, double resting, double present, double remaining)
{
  switch (colouring)
  {
    case Colouring::RESTING_LENGTH:
      return jet(resting);
    case Colouring::REMAINING_DEVELOPMENT:
      return jet(remaining);
    case Colouring::PHASE:
      return hue(part.phase + 0.5);
    case Colouring::PRESENT_LENGTH:
      break;
  }
  return jet(present);
}
}  // namespace devo_evo
