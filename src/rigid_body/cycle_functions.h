#pragma once

#include <cmath>

namespace devo_evo
{
/// sin(2 pi cycles), from additions and multiplications alone, within 2e-16. @pre |cycles| < 1e9
inline double sineOfCycles(double cycles)
{
  // To a quarter cycle around 0, where the sine is monotonic.
  double rest = cycles - std::nearbyint(cycles);
  if (rest > 0.25)
  {
    rest = 0.5 - rest;
  }
  else if (rest < -0.25)
  {
    rest = -0.5 - rest;
  }
  const double x = 6.283185307179586 * rest;
  const double square = x * x;
  double series = 1.0;
  for (int even = 22; even >= 2; even -= 2)  // x - x^3 / 3! + x^5 / 5! - ...; the first term left out is below 1e-17
  {
    series = 1.0 - square / (even * (even + 1)) * series;
  }
  return x * series;
}

/// cos(2 pi cycles), likewise.
inline double cosineOfCycles(double cycles)
{
  return sineOfCycles(cycles + 0.25);
}
}  // namespace devo_evo
