#include "evolution/portable_math.h"

#include "evolution/golden.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace devo_evo;

TEST(PortableLog, isExactAtOne)
{
  EXPECT_EQ(0.0, portableLog(1.0));
}

TEST(PortableLog, agreesWithTheCLibrary)
{
  for (double x = 0x1p-1000; x < 0x1p1000; x *= 1.0009)
  {
    ASSERT_NEAR(1.0, portableLog(x) / std::log(x), 1e-15) << x;
  }
  // Near 1 the logarithm is small: its relative error shows whether digits cancel.
  for (int i = 1; i <= 1000; ++i)
  {
    for (const double x : { 1.0 + 1e-6 * i, 1.0 - 1e-6 * i, 1.0 + 4e-4 * i, 1.0 - 9e-4 * i })
    {
      ASSERT_NEAR(1.0, portableLog(x) / std::log(x), 1e-15) << x;
    }
  }
}

TEST(LowerNormalQuantile, invertsTheDistributionFunction)
{
  // Phi(z) = erfc(-z / sqrt(2)) / 2; dividing its error by the density gives the error of z.
  const double density_at_0 = 1.0 / std::sqrt(2.0 * std::acos(-1.0));
  for (double p = 0x1p-54; p < 0.5; p *= 1.003)
  {
    const double z = lowerNormalQuantile(p);
    const double error = (0.5 * std::erfc(-z / std::sqrt(2.0)) - p) / (density_at_0 * std::exp(-0.5 * z * z));
    ASSERT_NEAR(0.0, error, 1e-13) << p;
  }
}

TEST(LowerNormalQuantile, takesTabulatedValues)
{
  EXPECT_EQ(0.0, lowerNormalQuantile(0.5));
  EXPECT_NEAR(-0.6744897501960817432, lowerNormalQuantile(0.25), 1e-15);
  EXPECT_NEAR(-1.2815515655446004, lowerNormalQuantile(0.1), 1e-15);
  EXPECT_NEAR(-3.0902323061678132, lowerNormalQuantile(0.001), 1e-15);
  EXPECT_NEAR(-9.262340089798408, lowerNormalQuantile(1e-20), 1e-14);
}

TEST(LowerNormalQuantile, isContinuousWhereTheApproximationsMeet)
{
  for (const double p : { 0.075, 0x1.e8a37a45fc32ep-37 /* exp(-25) */ })
  {
    EXPECT_NEAR(lowerNormalQuantile(std::nextafter(p, 0.0)), lowerNormalQuantile(std::nextafter(p, 1.0)), 1e-14);
  }
}

TEST(PortableMath, isTheSameToTheLastBitOnEveryPlatform)
{
  Sha256 logarithms;
  for (double x = 0x1p-1000; x < 0x1p1000; x *= 1.0009)
  {
    logarithms.add(portableLog(x));
  }
  EXPECT_EQ("8414424643fd4ae7", digestOf(logarithms));

  Sha256 quantiles;
  for (double p = 0x1p-54; p < 0.5; p *= 1.0003)
  {
    quantiles.add(lowerNormalQuantile(p));
  }
  EXPECT_EQ("eb6df484352f2621", digestOf(quantiles));
}
