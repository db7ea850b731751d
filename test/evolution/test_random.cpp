#include "devo_evo/evolution/random.h"

#include "evolution/golden.h"

#include <Random123/philox.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace devo_evo;

namespace
{
const char* const ARM = "evo_devo/paper/self_adaptive";

RandomStream stream(int64_t seed = 1, const std::string& arm = ARM, int64_t trial = 2, int64_t generation = 3,
                    int64_t individual = 4, RandomPurpose purpose = RandomPurpose::MUTATION)
{
  return RandomStream(seed, arm, trial, generation, individual, purpose);
}

/// Largest distance between the empirical distribution of the values and a distribution function (Kolmogorov-Smirnov).
template <class Distribution>
double largestDistance(std::vector<double> values, Distribution distribution)
{
  std::sort(values.begin(), values.end());
  const double count = static_cast<double>(values.size());
  double largest = 0.0;
  for (size_t i = 0; i < values.size(); ++i)
  {
    const double expected = distribution(values[i]);
    largest = std::max({ largest, std::abs(expected - static_cast<double>(i) / count),
                         std::abs(expected - static_cast<double>(i + 1) / count) });
  }
  return largest;
}

/// Correlation of two samples of the same length, in standard errors.
double correlation(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0, square_a = 0.0, square_b = 0.0;
  for (size_t i = 0; i < a.size(); ++i)
  {
    sum += a[i] * b[i];
    square_a += a[i] * a[i];
    square_b += b[i] * b[i];
  }
  return std::sqrt(static_cast<double>(a.size())) * sum / std::sqrt(square_a * square_b);
}

std::vector<double> normals(RandomStream random, size_t count)
{
  std::vector<double> values(count);
  std::generate(values.begin(), values.end(), [&random] { return random.normal(); });
  return values;
}

constexpr size_t COUNT = 200000;

// Kolmogorov-Smirnov distances exceed this with a probability of about 1e-4.
const double KS_LIMIT = 2.23 / std::sqrt(static_cast<double>(COUNT));
}  // namespace

TEST(Philox, givesTheKnownAnswersOfItsAuthors)
{
  const r123::Philox4x64::ctr_type zeros = { { 0, 0, 0, 0 } };
  const r123::Philox4x64::ctr_type of_zeros = { { 0x16554d9eca36314c, 0xdb20fe9d672d0fdc, 0xd7e772cee186176b,
                                                  0x7e68b68aec7ba23b } };
  EXPECT_EQ(of_zeros, r123::Philox4x64()(zeros, { { 0, 0 } }));

  const r123::Philox4x64::ctr_type pi = { { 0x243f6a8885a308d3, 0x13198a2e03707344, 0xa4093822299f31d0,
                                            0x082efa98ec4e6c89 } };
  const r123::Philox4x64::ctr_type of_pi = { { 0xa528f45403e61d95, 0x38c72dbd566e9788, 0xa5a1610e72fd18b5,
                                               0x57bd43b5e52b7fe6 } };
  EXPECT_EQ(of_pi, r123::Philox4x64()(pi, { { 0x452821e638d01377, 0xbe5466cf34e90c6c } }));
}

TEST(RandomStream, isPhiloxUnderTheDocumentedKeyAndCounter)
{
  // echo -n evo_devo/paper/self_adaptive | sha256sum begins with the bytes of this number, lowest first.
  const uint64_t arm_hash = 0x73c5b30c1c7dc9ab;
  RandomStream random = stream(1, ARM, 2, 3, 4, RandomPurpose::MUTATION);
  for (uint64_t block = 0; block < 3; ++block)
  {
    const r123::Philox4x64::ctr_type expected =
        r123::Philox4x64()({ { 2, 3, 4, uint64_t{ 2 } << 32 | block } }, { { 1, arm_hash } });
    for (const uint64_t bits : expected)
    {
      EXPECT_EQ(bits, random.bits());
    }
  }
}

TEST(RandomStream, everyPartOfItsKeyMatters)
{
  std::vector<RandomStream> streams = { stream(),
                                        stream(2),
                                        stream(1, "evo/paper/self_adaptive"),
                                        stream(1, ARM, 3),
                                        stream(1, ARM, 2, 4),
                                        stream(1, ARM, 2, 3, 5),
                                        stream(1, ARM, 2, 3, 4, RandomPurpose::FOUNDER_GENOME) };
  for (size_t i = 0; i < streams.size(); ++i)
  {
    for (size_t j = 0; j < i; ++j)
    {
      EXPECT_LT(std::abs(correlation(normals(streams[i], 20000), normals(streams[j], 20000))), 4.0) << i << " " << j;
    }
  }
}

TEST(RandomStream, withTheSameKeyIsTheSame)
{
  EXPECT_EQ(normals(stream(), 100), normals(stream(), 100));
}

TEST(RandomStream, successiveDrawsAreIndependent)
{
  std::vector<double> first = normals(stream(), COUNT);
  for (size_t lag = 1; lag <= 5; ++lag)
  {
    const std::vector<double> shifted(first.begin() + static_cast<std::ptrdiff_t>(lag), first.end());
    const std::vector<double> start(first.begin(), first.end() - static_cast<std::ptrdiff_t>(lag));
    EXPECT_LT(std::abs(correlation(start, shifted)), 4.0) << lag;
  }
}

TEST(RandomStream, uniformDrawsAreUniform)
{
  RandomStream random = stream();
  std::vector<double> values(COUNT);
  std::generate(values.begin(), values.end(), [&random] { return random.uniform(); });
  EXPECT_GE(*std::min_element(values.begin(), values.end()), 0.0);
  EXPECT_LT(*std::max_element(values.begin(), values.end()), 1.0);
  EXPECT_LT(largestDistance(values, [](double x) { return x; }), KS_LIMIT);
}

TEST(RandomStream, uniformDrawsStayWithinTheirRange)
{
  RandomStream random = stream();
  double lowest = 1.0, highest = -1.0;
  for (size_t i = 0; i < COUNT; ++i)
  {
    const double value = random.uniform(-0.25, 0.25);
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
  EXPECT_GE(lowest, -0.25);
  EXPECT_LT(lowest, -0.2499);
  EXPECT_LT(highest, 0.25);
  EXPECT_GT(highest, 0.2499);

  // Only two numbers lie in this range, and half of the unrounded draws are nearer to its excluded end.
  const double next = std::nextafter(1.0, 2.0);
  for (int i = 0; i < 100; ++i)
  {
    EXPECT_EQ(1.0, random.uniform(1.0, next));
  }
}

TEST(RandomStream, normalDrawsHaveTheMomentsOfTheNormalDistribution)
{
  double sums[5] = {};
  for (const double z : normals(stream(), COUNT))
  {
    double power = 1.0;
    for (double& sum : sums)
    {
      sum += power;
      power *= z;
    }
  }
  // Standard error of the mean of z^k: sqrt((E z^2k - (E z^k)^2) / n), with E z^2, 4, 6, 8 = 1, 3, 15, 105.
  const double n = static_cast<double>(COUNT);
  EXPECT_NEAR(0.0, sums[1] / n, 4.0 * std::sqrt(1.0 / n));
  EXPECT_NEAR(1.0, sums[2] / n, 4.0 * std::sqrt(2.0 / n));
  EXPECT_NEAR(0.0, sums[3] / n, 4.0 * std::sqrt(15.0 / n));
  EXPECT_NEAR(3.0, sums[4] / n, 4.0 * std::sqrt(96.0 / n));
}

TEST(RandomStream, normalDrawsFollowTheNormalDistribution)
{
  const auto distribution = [](double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); };
  EXPECT_LT(largestDistance(normals(stream(), COUNT), distribution), KS_LIMIT);
}

TEST(RandomStream, normalDrawsHaveNormalTails)
{
  // Two-sided probabilities of exceeding 3 and 4 standard deviations.
  RandomStream random = stream();
  constexpr int count = 2000000;
  int beyond_3 = 0, beyond_4 = 0;
  for (int i = 0; i < count; ++i)
  {
    const double distance = std::abs(random.normal());
    beyond_3 += distance > 3.0;
    beyond_4 += distance > 4.0;
  }
  EXPECT_NEAR(count * 2.6997960632601866e-3, beyond_3, 4.0 * std::sqrt(count * 2.6998e-3));
  EXPECT_NEAR(count * 6.334248366623996e-5, beyond_4, 4.0 * std::sqrt(count * 6.3342e-5));
}

TEST(RandomStream, integersAreEquallyFrequent)
{
  RandomStream random = stream();
  std::vector<int> frequency(7, 0);
  for (size_t i = 0; i < COUNT; ++i)
  {
    ++frequency[random.below(frequency.size())];
  }
  const double p = 1.0 / 7;
  for (const int count : frequency)
  {
    EXPECT_NEAR(COUNT * p, count, 4.0 * std::sqrt(COUNT * p * (1.0 - p)));
  }
  EXPECT_EQ(0u, random.below(1));
}

TEST(RandomStream, largeIntegersAreUnbiased)
{
  // Of three quarters of 2^64, plain remainders would fall into the first third twice as often as into the others.
  const uint64_t bound = uint64_t{ 3 } << 62;
  RandomStream random = stream();
  double in_first_third = 0;
  for (size_t i = 0; i < COUNT; ++i)
  {
    in_first_third += random.below(bound) < bound / 3;
  }
  EXPECT_NEAR(COUNT / 3.0, in_first_third, 4.0 * std::sqrt(COUNT * 2.0 / 9.0));
}

TEST(RandomStream, isTheSameToTheLastBitOnEveryPlatform)
{
  Sha256 hash;
  RandomStream random = stream();
  for (int i = 0; i < 10000; ++i)
  {
    hash.add(random.uniform()).add(random.normal()).add(random.below(48)).add(random.uniform(-1.0, 1.0));
  }
  EXPECT_EQ("66c53e3cb5d2dd4a", digestOf(hash));
}
