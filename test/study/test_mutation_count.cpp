// What our operator changes, against the paper's analysis (its Supplementary Fig. S4 and tables).
#include "study/mutation_count.h"

#include "evolution/settings_of.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace devo_evo;

namespace
{
constexpr int64_t REPRODUCTIONS = 4000;

/// Within four standard errors.
void expectMean(double expected, const Spread& counted, const std::string& what)
{
  const double error = counted.standard_deviation / std::sqrt(static_cast<double>(REPRODUCTIONS));
  EXPECT_NEAR(expected, counted.mean, 4.0 * error + 1e-9) << what;
}
}  // namespace

TEST(MutationCount, agreesWithTheAnalysisOfThePaper)
{
  for (const TreatmentSpec& spec : TREATMENTS)
  {
    for (const double rate : { 1.0 / 48, 0.5, 1.0 })
    {
      const EvolutionSettings settings = settingsOf(spec.treatment, Profile::PAPER, rate);
      const int n = 2 + (spec.body_develops ? 1 : 0) + (spec.control_develops ? 1 : 0);
      const double none = std::pow(1.0 - 1.0 / n, n);  // of the traits is selected: one is picked
      const MutationCount count = countMutations(settings, paperBody(), REPRODUCTIONS);
      expectMean(48.0 * (1.0 - std::pow(1.0 - rate / n, n) + rate * none), count.voxels, settings.arm());
      expectMean(48.0 * rate * (1.0 + none), count.genes, settings.arm());
    }
  }
}

TEST(MutationCount, ofGenesIsSixtyAnd63Point1875Lambda)
{
  // The paper prints 63.8175 for four traits, against its own formula.
  expectMean(60.0, countMutations(settingsOf(Treatment::EVO, Profile::PAPER, 1.0), paperBody(), REPRODUCTIONS).genes,
             "n=2");
  expectMean(63.1875,
             countMutations(settingsOf(Treatment::EVO_DEVO, Profile::PAPER, 1.0), paperBody(), REPRODUCTIONS).genes,
             "n=4");
}

TEST(MutationCount, ofNothingIsNothing)
{
  const MutationCount count = countMutations(settingsOf(Treatment::EVO_DEVO, Profile::PAPER, 0.0), paperBody(), 100);
  EXPECT_EQ(count.voxels.mean, 0.0);
  EXPECT_EQ(count.genes.standard_deviation, 0.0);
}
