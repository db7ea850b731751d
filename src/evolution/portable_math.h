#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace devo_evo
{
// Transcendental functions from IEEE-754 + - * / and square roots alone, which every processor rounds alike. The C
// library's differ between versions in the last bit, and one bit changes a lineage.

/// Natural logarithm, with a relative error below 4e-16. @pre x is a positive, finite, normal number.
inline double portableLog(double x)
{
  // x = mantissa 2^exponent with the mantissa in [sqrt(1/2), sqrt(2)).
  uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  int exponent = static_cast<int>(bits >> 52) - 1023;
  bits = (bits & 0x000fffffffffffff) | 0x3ff0000000000000;
  double mantissa;
  std::memcpy(&mantissa, &bits, sizeof mantissa);
  if (mantissa >= 1.4142135623730951)
  {
    mantissa *= 0.5;
    ++exponent;
  }

  // log(mantissa) = 2 artanh(s) = 2 s (1 + s^2 / 3 + s^4 / 5 + ...) with s = (mantissa - 1) / (mantissa + 1), |s| <
  // 0.172; the first term left out is below 2^-56.
  const double s = (mantissa - 1.0) / (mantissa + 1.0);
  const double s_squared = s * s;
  double series = 0.0;
  for (int odd = 21; odd >= 3; odd -= 2)
  {
    series = (series + 1.0 / odd) * s_squared;
  }

  // log(2) in two parts; the first has so few digits that its product with the exponent is exact.
  constexpr double log_2_high = 0x1.62e42fee00000p-1;
  constexpr double log_2_low = 0x1.a39ef35793c76p-33;
  return exponent * log_2_high + (2.0 * s + (2.0 * s * series + exponent * log_2_low));
}

/// A polynomial, its coefficients from the highest power of r to the constant.
template <size_t N>
double polynomial(const std::array<double, N>& coefficients, double r)
{
  double value = 0.0;
  for (const double coefficient : coefficients)
  {
    value = value * r + coefficient;
  }
  return value;
}

/// Lower half of the standard normal distribution's quantile function: the z <= 0 below which a deviate lies with
/// probability p, with a relative error below 1e-15. @pre p is a normal number in (0, 0.5].
///
/// M. J. Wichura, Algorithm AS 241 (PPND16), Applied Statistics 37 (1988) 477-484.
inline double lowerNormalQuantile(double p)
{
  using Coefficients = std::array<double, 8>;
  const double q = p - 0.5;
  if (q >= -0.425)
  {
    constexpr Coefficients numerator = { 2.5090809287301226727e+3, 3.3430575583588128105e+4, 6.7265770927008700853e+4,
                                         4.5921953931549871457e+4, 1.3731693765509461125e+4, 1.9715909503065514427e+3,
                                         1.3314166789178437745e+2, 3.3871328727963666080e+0 };
    constexpr Coefficients denominator = { 5.2264952788528545610e+3, 2.8729085735721942674e+4,
                                           3.9307895800092710610e+4, 2.1213794301586595867e+4,
                                           5.3941960214247511077e+3, 6.8718700749205790830e+2,
                                           4.2313330701600911252e+1, 1.0 };
    const double r = 0.180625 - q * q;
    return q * polynomial(numerator, r) / polynomial(denominator, r);
  }
  const double r = std::sqrt(-portableLog(p));
  if (r <= 5.0)
  {
    constexpr Coefficients numerator = { 7.74545014278341407640e-4, 2.27238449892691845833e-2,
                                         2.41780725177450611770e-1, 1.27045825245236838258e+0,
                                         3.64784832476320460504e+0, 5.76949722146069140550e+0,
                                         4.63033784615654529590e+0, 1.42343711074968357734e+0 };
    constexpr Coefficients denominator = { 1.05075007164441684324e-9, 5.47593808499534494600e-4,
                                           1.51986665636164571966e-2, 1.48103976427480074590e-1,
                                           6.89767334985100004550e-1, 1.67638483018380384940e+0,
                                           2.05319162663775882187e+0, 1.0 };
    return -polynomial(numerator, r - 1.6) / polynomial(denominator, r - 1.6);
  }
  constexpr Coefficients numerator = { 2.01033439929228813265e-7, 2.71155556874348757815e-5, 1.24266094738807843860e-3,
                                       2.65321895265761230930e-2, 2.96560571828504891230e-1, 1.78482653991729133580e+0,
                                       5.46378491116411436990e+0, 6.65790464350110377720e+0 };
  constexpr Coefficients denominator = { 2.04426310338993978564e-15, 1.42151175831644588870e-7,
                                         1.84631831751005468180e-5,  7.86869131145613259100e-4,
                                         1.48753612908506148525e-2,  1.36929880922735805310e-1,
                                         5.99832206555887937690e-1,  1.0 };
  return -polynomial(numerator, r - 5.0) / polynomial(denominator, r - 5.0);
}
}  // namespace devo_evo
