// Distributions of random genomes and mutations against numbers worked out from the definitions in the paper and in its
// released code. Seeds are fixed; tolerances are four standard errors and half a unit of a table's last digit.

#include "devo_evo/evolution/genome.h"
#include "devo_evo/soft_body/lattice.h"
#include "evolution/settings_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace devo_evo;

namespace
{
const Lattice LATTICE(4, 4, 3);
const double PI = std::acos(-1.0);

/// Mean and standard error of what is added.
class Sample
{
public:
  void add(double value)
  {
    ++count_;
    sum_ += value;
    sum_of_squares_ += value * value;
  }
  double mean() const { return sum_ / count_; }
  double standardError() const { return std::sqrt(std::max(0.0, sum_of_squares_ / count_ - mean() * mean()) / count_); }

private:
  double count_ = 0.0;
  double sum_ = 0.0;
  double sum_of_squares_ = 0.0;
};

#define EXPECT_MEAN(expected, sample, rounding)                                       \
  EXPECT_NEAR(expected, (sample).mean(), 4.0 * (sample).standardError() + (rounding)) \
      << "standard error " << (sample).standardError()

Genome founder(const EvolutionSettings& settings, int64_t id)
{
  return bornGenome(settings, layoutOf(settings), 0, 0, id, nullptr);
}

Genome childOf(const Genome& parent, const EvolutionSettings& settings, int64_t id)
{
  return bornGenome(settings, layoutOf(settings), 0, 1, id, &parent);
}

/// Voxels in which any value of the program differs.
int changedVoxels(const DevelopmentalProgram& a, const DevelopmentalProgram& b)
{
  int changed = 0;
  for (int voxel = 0; voxel < LATTICE.voxelCount(); ++voxel)
  {
    changed += a.morphology_initial[voxel] != b.morphology_initial[voxel] ||
               a.morphology_final[voxel] != b.morphology_final[voxel] ||
               a.control_initial[voxel] != b.control_initial[voxel] || a.control_final[voxel] != b.control_final[voxel];
  }
  return changed;
}

double meanOf(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}
}  // namespace

TEST(RandomGenome, usesAThirdOfTheDevelopmentalWindows)
{
  for (const Profile profile : { Profile::PAPER, Profile::RELEASED_CODE })
  {
    const EvolutionSettings settings = settingsOf(Treatment::EVO_DEVO, profile);
    Sample morphology, control;
    for (int64_t id = 0; id < 5000; ++id)
    {
      const DevelopmentalProgram program = founder(settings, id).program;
      morphology.add(morphologyWindow(program, layoutOf(settings)));
      control.add(controlWindow(program, layoutOf(settings)));
    }
    EXPECT_MEAN(1.0 / 3, morphology, 0.0);
    EXPECT_MEAN(1.0 / 3, control, 0.0);
  }
}

TEST(RandomGenome, isUniformWithinTheLimits)
{
  for (const EvolutionSettings& settings :
       { settingsOf(Treatment::EVO_DEVO, Profile::PAPER), settingsOf(Treatment::EVO_DEVO, Profile::RELEASED_CODE) })
  {
    for (const TraitSpec& trait : evolvingTraits(layoutOf(settings)))
    {
      // First and second moment of voxel 47, which no mirror image overwrites, in units of the limit.
      Sample value, square;
      for (int64_t id = 0; id < 20000; ++id)
      {
        const double x = (founder(settings, id).program.*trait.values)[47] / trait.maximum;
        value.add(x);
        square.add(x * x);
      }
      EXPECT_MEAN(0.0, value, 0.0) << trait.name;
      EXPECT_MEAN(1.0 / 3, square, 0.0) << trait.name;
    }
  }
}

TEST(InitialMutationRates, areTheMinimumInThePaper)
{
  const Genome genome = founder(settingsOf(Treatment::EVO_DEVO, Profile::PAPER), 0);
  EXPECT_EQ(std::vector<double>(48, 1.0 / 48), genome.mutation_rate);
}

TEST(InitialMutationRates, haveBeenMutatedOnceInTheReleasedCode)
{
  const EvolutionSettings settings = settingsOf(Treatment::EVO_DEVO, Profile::RELEASED_CODE);
  Sample rates, at_minimum;
  for (int64_t id = 0; id < 5000; ++id)
  {
    for (const double rate : founder(settings, id).mutation_rate)
    {
      rates.add(rate);
      at_minimum.add(rate == 1.0 / 48);
    }
  }
  EXPECT_MEAN(1.0 / 48 + 4.0 / 48 / std::sqrt(2 * PI), rates, 0.0);  // 0.0541
  EXPECT_MEAN(0.5, at_minimum, 0.0);
}

TEST(MutationRates, driftUpwardsWithoutSelection)
{
  // Means after so many reproductions, from the released code's start.
  const std::vector<std::pair<int, double>> expected = {
    { 1, 0.077 }, { 10, 0.19 }, { 20, 0.27 }, { 50, 0.41 }, { 100, 0.49 }
  };
  const EvolutionSettings settings = settingsOf(Treatment::EVO, Profile::RELEASED_CODE);
  std::vector<Sample> means(101);
  for (int64_t lineage = 0; lineage < 200; ++lineage)
  {
    Genome genome = founder(settings, lineage);
    for (int step = 1; step <= 100; ++step)
    {
      genome = bornGenome(settings, layoutOf(settings), 0, step, lineage, &genome);
      means[step].add(meanOf(genome.mutation_rate));
    }
  }
  for (const auto& [step, mean] : expected)
  {
    EXPECT_MEAN(mean, means[step], 0.005) << step;
  }
}

TEST(MutatedTraits, areAsManyAsTheProfileSays)
{
  struct Row
  {
    Treatment treatment;
    Profile profile;
    std::vector<double> probability;  // of 1, 2, ... traits
  };
  const std::vector<Row> rows = {
    { Treatment::EVO, Profile::RELEASED_CODE, { 2.0 / 3, 1.0 / 3 } },
    { Treatment::EVO, Profile::PAPER, { 0.75, 0.25 } },
    { Treatment::EVO_DEVO, Profile::RELEASED_CODE, { 0.617143, 0.308571, 0.068571, 0.005714 } },
    { Treatment::EVO_DEVO, Profile::PAPER, { 0.738281, 0.210938, 0.046875, 0.003906 } },
  };
  for (const Row& row : rows)
  {
    const EvolutionSettings settings = settingsOf(row.treatment, row.profile, 0.0);
    const Genome parent = founder(settings, 0);
    std::vector<Sample> frequency(row.probability.size());
    std::vector<Sample> selected(row.probability.size());
    for (int64_t id = 0; id < 40000; ++id)
    {
      RandomStream random(1, settings.arm(), 0, 1, id, RandomPurpose::MUTATION);
      MutationRecord record;
      mutate(parent, settings, layoutOf(settings), random, &record);
      const std::vector<TraitSpec> traits = evolvingTraits(layoutOf(settings));
      for (size_t i = 0; i < traits.size(); ++i)
      {
        frequency[i].add(record.traits.size() == i + 1);
        selected[i].add(std::count(record.traits.begin(), record.traits.end(), traits[i].name));
      }
    }
    double expected_traits = 0.0;
    for (size_t i = 0; i < row.probability.size(); ++i)
    {
      EXPECT_MEAN(row.probability[i], frequency[i], 5e-7) << settings.arm() << " " << i + 1;
      expected_traits += static_cast<double>(i + 1) * row.probability[i];
    }
    for (const Sample& one : selected)
    {
      EXPECT_MEAN(expected_traits / static_cast<double>(selected.size()), one, 5e-6) << settings.arm();
    }
  }
}

TEST(ChangedVoxels, areAsManyAsTheSupplementOfThePaperSays)
{
  const double rates[8] = { 1.0 / 48, 2.0 / 48, 4.0 / 48, 8.0 / 48, 16.0 / 48, 24.0 / 48, 32.0 / 48, 48.0 / 48 };
  struct Row
  {
    Treatment treatment;
    Profile profile;
    double changed[8];
  };
  const std::vector<Row> rows = {
    { Treatment::EVO, Profile::PAPER, { 1.245, 2.479, 4.917, 9.667, 18.667, 27, 34.667, 48 } },
    { Treatment::EVO_DEVO, Profile::PAPER, { 1.309, 2.602, 5.142, 10.045, 19.171, 27.457, 34.977, 48 } },
    { Treatment::EVO, Profile::RELEASED_CODE, { 1.326, 2.639, 5.222, 10.222, 19.556, 28, 35.556, 48 } },
    { Treatment::EVO_DEVO, Profile::RELEASED_CODE, { 1.451, 2.880, 5.671, 10.992, 20.639, 29.057, 36.355, 48 } },
  };
  for (const Row& row : rows)
  {
    for (size_t i = 0; i < 8; ++i)
    {
      const EvolutionSettings settings = settingsOf(row.treatment, row.profile, rates[i]);
      const Genome parent = founder(settings, 0);
      Sample changed;
      for (int64_t id = 0; id < 8000; ++id)
      {
        changed.add(changedVoxels(parent.program, childOf(parent, settings, id).program));
      }
      EXPECT_MEAN(row.changed[i], changed, 0.0005) << settings.arm();
    }
  }
}

TEST(ChangedVoxels, ofFirstChildrenUnderSelfAdaptationAreAboutFive)
{
  // In the released code, where the rates have been mutated twice by then.
  const std::vector<std::pair<Treatment, double>> rows = { { Treatment::EVO, 4.8 }, { Treatment::EVO_DEVO, 5.2 } };
  for (const auto& [treatment, expected] : rows)
  {
    const EvolutionSettings settings = settingsOf(treatment, Profile::RELEASED_CODE);
    Sample changed, unchanged;
    for (int64_t id = 0; id < 20000; ++id)
    {
      const Genome parent = founder(settings, id);
      const int voxels = changedVoxels(parent.program, childOf(parent, settings, id).program);
      changed.add(voxels);
      unchanged.add(voxels == 0);
    }
    EXPECT_MEAN(expected, changed, 0.05);
    EXPECT_MEAN(0.05, unchanged, 0.015);
  }
}

TEST(Clipping, putsThirtyNinePercentOfMutationsOfUniformValuesOnABound)
{
  // P(|v + z| > 1) for v uniform in (-1, 1): 2 Phi(-2) + phi(0) - phi(2) = 0.39046; the same for phases, whose
  // mutations scale with their limit.
  const double expected = std::erfc(std::sqrt(2.0)) + (1.0 - std::exp(-2.0)) / std::sqrt(2.0 * PI);
  for (const Profile profile : { Profile::PAPER, Profile::RELEASED_CODE })
  {
    const EvolutionSettings settings = settingsOf(Treatment::EVO_DEVO, profile, 1.0);
    for (const TraitSpec& trait : evolvingTraits(layoutOf(settings)))
    {
      Sample on_bound;
      for (int64_t id = 0; id < 4000; ++id)
      {
        const Genome parent = founder(settings, id);
        const Genome child = childOf(parent, settings, id);
        const std::vector<double>& values = child.program.*trait.values;
        if (values != parent.program.*trait.values)
        {
          on_bound.add(std::abs(values[47]) == trait.maximum);
        }
      }
      EXPECT_MEAN(expected, on_bound, 0.0) << trait.name;
    }
  }
}

TEST(NeutralDrift, leadsToTheStationaryDistributionOfClippedRandomWalks)
{
  // About 45 % of the values on a bound, and windows of 0.44.
  const EvolutionSettings settings = settingsOf(Treatment::EVO_DEVO, Profile::PAPER, 1.0);
  Sample on_bound, morphology, control;
  for (int64_t lineage = 0; lineage < 400; ++lineage)
  {
    Genome genome = founder(settings, lineage);
    for (int64_t generation = 1; generation <= 60; ++generation)
    {
      genome = bornGenome(settings, layoutOf(settings), 0, generation, lineage, &genome);
    }
    for (const double phase : genome.program.control_initial)
    {
      on_bound.add(std::abs(phase) == 0.25);
    }
    morphology.add(morphologyWindow(genome.program, layoutOf(settings)));
    control.add(controlWindow(genome.program, layoutOf(settings)));
  }
  EXPECT_MEAN(0.45, on_bound, 0.005);
  EXPECT_MEAN(0.44, morphology, 0.005);
  EXPECT_MEAN(0.44, control, 0.005);
}
