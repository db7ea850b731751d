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

Genome founder(const EvolutionSettings& settings, int64_t id = 0, const Body& body = paperBody())
{
  return bornGenome(settings, body.layout(settings), 0, 0, id, nullptr);
}

std::vector<EvolutionSettings> everyArm()
{
  std::vector<EvolutionSettings> arms;
  for (const TreatmentSpec& spec : TREATMENTS)
  {
    const Treatment treatment = spec.treatment;
    for (const Profile profile : { Profile::PAPER, Profile::RELEASED_CODE })
    {
      arms.push_back(settingsOf(treatment, profile));
      arms.push_back(settingsOf(treatment, profile, 0.5));
    }
  }
  return arms;
}

std::string complaint(const Genome& genome, const EvolutionSettings& settings)
{
  try
  {
    validate(genome, settings, layoutOf(settings));
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
  return "";
}
}  // namespace

TEST(Traits, areTwoWithoutDevelopmentAndFourWithIt)
{
  const std::vector<TraitSpec> evo = evolvingTraits(layoutOf(settingsOf(Treatment::EVO, Profile::PAPER)));
  ASSERT_EQ(2u, evo.size());
  EXPECT_EQ("size_gene_initial", evo[0].name);
  EXPECT_EQ("phase_initial", evo[1].name);

  const std::vector<TraitSpec> evo_devo = evolvingTraits(layoutOf(settingsOf(Treatment::EVO_DEVO, Profile::PAPER)));
  ASSERT_EQ(4u, evo_devo.size());
  EXPECT_EQ("size_gene_initial", evo_devo[0].name);
  EXPECT_EQ("size_gene_final", evo_devo[1].name);
  EXPECT_EQ("phase_initial", evo_devo[2].name);
  EXPECT_EQ("phase_final", evo_devo[3].name);
}

TEST(Traits, sizesAreMirroredAndPhasesHaveTheProfilesRange)
{
  for (const EvolutionSettings& settings : everyArm())
  {
    const double phase_range = settings.profile == Profile::PAPER ? 0.25 : 1.0;
    for (const TraitSpec& trait : evolvingTraits(layoutOf(settings)))
    {
      const bool is_size = trait.name.find("size_gene") == 0;
      EXPECT_EQ(is_size, trait.mirrored());
      EXPECT_EQ(is_size ? 1.0 : phase_range, trait.maximum);
      EXPECT_EQ(is_size ? 1.0 : phase_range, trait.mutation_sigma);
    }
  }
}

TEST(Genome, isValidWhenBornAndAfterManyMutationsInEveryArm)
{
  for (const EvolutionSettings& settings : everyArm())
  {
    Genome genome = founder(settings);
    EXPECT_EQ("", complaint(genome, settings));
    for (int64_t generation = 1; generation <= 100; ++generation)
    {
      genome = bornGenome(settings, layoutOf(settings), 0, generation, generation, &genome);
      ASSERT_EQ("", complaint(genome, settings)) << settings.arm();
    }
  }
}

TEST(Genome, drawsTheHalfAtUpperXAndMirrorsItToTheOther)
{
  const EvolutionSettings settings = settingsOf(Treatment::EVO, Profile::PAPER, 0.5);
  RandomStream random(1, "arm", 0, 0, 0, RandomPurpose::FOUNDER_GENOME);
  RandomStream same_random = random;
  const std::vector<double> sizes = randomGenome(settings, layoutOf(settings), random).program.morphology_initial;
  for (int z = 0; z < 3; ++z)
  {
    for (int y = 0; y < 4; ++y)
    {
      const double drawn[4] = { same_random.uniform(-1, 1), same_random.uniform(-1, 1), same_random.uniform(-1, 1),
                                same_random.uniform(-1, 1) };
      EXPECT_EQ(drawn[3], sizes[LATTICE.index(0, y, z)]);
      EXPECT_EQ(drawn[2], sizes[LATTICE.index(1, y, z)]);
      EXPECT_EQ(drawn[2], sizes[LATTICE.index(2, y, z)]);
      EXPECT_EQ(drawn[3], sizes[LATTICE.index(3, y, z)]);
    }
  }
}

TEST(Genome, keepsAMiddleColumnOfItsOwn)
{
  const Lattice lattice(5, 2, 2);
  const std::shared_ptr<const Body> body = bodyOf(5, 2, 2);
  const EvolutionSettings settings = settingsOf(Treatment::EVO, Profile::PAPER, 1.0);
  Genome genome = founder(settings, 0, *body);
  genome = bornGenome(settings, body->layout(settings), 0, 1, 1, &genome);
  const std::vector<double>& sizes = genome.program.morphology_initial;
  for (int row = 0; row < 4; ++row)
  {
    const double* x = &sizes[5 * row];
    EXPECT_EQ(x[0], x[4]);
    EXPECT_EQ(x[1], x[3]);
    EXPECT_NE(x[2], x[1]);
    EXPECT_NE(x[2], x[0]);
  }
}

TEST(Genome, doesNotMirrorPhases)
{
  const std::vector<double> phases = founder(settingsOf(Treatment::EVO, Profile::PAPER)).program.control_initial;
  for (int voxel = 0; voxel < LATTICE.voxelCount(); ++voxel)
  {
    EXPECT_NE(phases[voxel], phases[LATTICE.mirrored(voxel)]);
  }
}

TEST(Genome, hasNoMutationRatesOfItsOwnIfTheyAreFixed)
{
  const EvolutionSettings settings = settingsOf(Treatment::EVO_DEVO, Profile::RELEASED_CODE, 0.5);
  const Genome parent = founder(settings);
  EXPECT_TRUE(parent.mutation_rate.empty());
  EXPECT_TRUE(bornGenome(settings, layoutOf(settings), 0, 1, 1, &parent).mutation_rate.empty());
}

TEST(Mutation, leavesOtherTraitsAlone)
{
  const EvolutionSettings settings = settingsOf(Treatment::EVO_DEVO, Profile::PAPER, 1.0);
  const Genome parent = founder(settings);
  for (int64_t id = 0; id < 100; ++id)
  {
    RandomStream random(1, "arm", 0, 1, id, RandomPurpose::MUTATION);
    MutationRecord record;
    const Genome child = mutate(parent, settings, layoutOf(settings), random, &record);
    ASSERT_FALSE(record.traits.empty());
    for (const TraitSpec& trait : evolvingTraits(layoutOf(settings)))
    {
      const bool selected = std::find(record.traits.begin(), record.traits.end(), trait.name) != record.traits.end();
      EXPECT_EQ(selected, child.program.*trait.values != parent.program.*trait.values);
    }
  }
}

TEST(Mutation, usesTheChildsOwnRates)
{
  // So strong a meta-mutation sends most rates to 0 or 1: certain not to mutate, or certain to.
  EvolutionSettings settings = settingsOf(Treatment::EVO, Profile::PAPER);
  settings.minimum_mutation_rate = 0.0;
  settings.meta_mutation_sigma = 1.0;
  const Genome parent = founder(settings);
  int certain = 0;
  for (int64_t id = 0; id < 100; ++id)
  {
    const Genome child = bornGenome(settings, layoutOf(settings), 0, 1, id, &parent);
    if (child.program.control_initial == parent.program.control_initial)
    {
      continue;
    }
    for (int voxel = 0; voxel < LATTICE.voxelCount(); ++voxel)
    {
      const double rate = child.mutation_rate[voxel];
      if (rate == 0.0 || rate == 1.0)
      {
        ++certain;
        ASSERT_EQ(rate == 1.0, child.program.control_initial[voxel] != parent.program.control_initial[voxel]);
      }
    }
  }
  EXPECT_GT(certain, 1000);
}

TEST(Mutation, atRateZeroCopiesTheParent)
{
  const EvolutionSettings settings = settingsOf(Treatment::EVO_DEVO, Profile::PAPER, 0.0);
  const Genome parent = founder(settings);
  EXPECT_EQ(parent, bornGenome(settings, layoutOf(settings), 0, 1, 1, &parent));
}

TEST(BornGenome, dependsOnSeedArmTrialGenerationAndId)
{
  EvolutionSettings settings = settingsOf(Treatment::EVO_DEVO, Profile::PAPER);
  const Genome parent = founder(settings);
  const Genome child = bornGenome(settings, layoutOf(settings), 3, 4, 5, &parent);
  EXPECT_EQ(child, bornGenome(settings, layoutOf(settings), 3, 4, 5, &parent));
  EXPECT_FALSE(child == bornGenome(settings, layoutOf(settings), 2, 4, 5, &parent));
  EXPECT_FALSE(child == bornGenome(settings, layoutOf(settings), 3, 3, 5, &parent));
  EXPECT_FALSE(child == bornGenome(settings, layoutOf(settings), 3, 4, 6, &parent));
  settings.seed = 2;
  EXPECT_FALSE(child == bornGenome(settings, layoutOf(settings), 3, 4, 5, &parent));
}

TEST(GenomeValidation, namesArrayVoxelValueAndRule)
{
  const EvolutionSettings paper = settingsOf(Treatment::EVO_DEVO, Profile::PAPER);
  Genome genome = founder(paper);
  genome.program.control_final[17] = 0.5;
  EXPECT_EQ("phase_final[17] is 0.5; it must lie within -0.25 to 0.25", complaint(genome, paper));
  EXPECT_EQ("", complaint(genome, settingsOf(Treatment::EVO_DEVO, Profile::RELEASED_CODE)));

  genome = founder(paper);
  genome.program.morphology_initial[3] = 0.5;
  genome.program.morphology_initial[0] = 0.75;
  EXPECT_EQ("size_gene_initial[0] is 0.75; it must equal its mirror image, [3], which is 0.5",
            complaint(genome, paper));

  genome = founder(paper);
  genome.mutation_rate[2] = NAN;
  EXPECT_EQ("mutation_rate[2] is nan; it must lie within 0.020833333333333332 to 1", complaint(genome, paper));
}

TEST(GenomeValidation, wantsMutationRatesExactlyIfTheyEvolve)
{
  const EvolutionSettings self_adaptive = settingsOf(Treatment::EVO, Profile::PAPER);
  const EvolutionSettings fixed = settingsOf(Treatment::EVO, Profile::PAPER, 0.5);
  EXPECT_EQ("mutation_rate has 0 values; self-adaptation needs one per voxel, 48",
            complaint(founder(fixed), self_adaptive));
  EXPECT_EQ("mutation_rate has 48 values; with a fixed mutation rate it must have none",
            complaint(founder(self_adaptive), fixed));
}

TEST(GenomeValidation, refusesDevelopmentWhereThereIsNone)
{
  const EvolutionSettings evo = settingsOf(Treatment::EVO, Profile::PAPER);
  Genome genome = founder(evo);
  genome.program.control_initial[5] = 0.0;
  genome.program.control_final[5] = 0.125;
  EXPECT_EQ("phase_final[5] is 0.125; without development it must equal the initial value, which is 0",
            complaint(genome, evo));
}

TEST(GenomeValidation, refusesTheWrongGrid)
{
  const EvolutionSettings settings = settingsOf(Treatment::EVO, Profile::PAPER);
  EXPECT_THROW(validate(founder(settings, 0, *bodyOf(4, 4, 2)), settings, layoutOf(settings)), InvalidInput);
}

TEST(Hashes, areTheDocumentedHalfOfSha256)
{
  Genome genome;
  EXPECT_EQ("66687aadf862bd776c8fc18b8e9f8e20", toHex(phenotypeHash(genome.program)));  // of 4 zeros of 8 bytes
  EXPECT_EQ("2c34ce1df23b838c5abf2a7f6437cca3", toHex(genomeHash(genome)));             // of 5 zeros of 8 bytes
  genome.program = { { 0.5 }, { -1.0 }, { 0.25 }, { 0.0 } };
  genome.mutation_rate = { 1.0 / 48 };
  EXPECT_EQ("28c38a2662b14b552c1d8dfa404a545c", toHex(phenotypeHash(genome.program)));
  EXPECT_EQ("5e63103182c4b479061235ed589cc6ee", toHex(genomeHash(genome)));
}

TEST(Hashes, ofPhenotypesDoNotDependOnMutationRates)
{
  const EvolutionSettings settings = settingsOf(Treatment::EVO_DEVO, Profile::PAPER);
  const Genome genome = founder(settings);
  Genome other = genome;
  other.mutation_rate[0] = 0.5;
  EXPECT_EQ(phenotypeHash(genome.program), phenotypeHash(other.program));
  EXPECT_NE(genomeHash(genome), genomeHash(other));
  other.program.control_final[47] += 0x1p-50;
  EXPECT_NE(phenotypeHash(genome.program), phenotypeHash(other.program));
}
