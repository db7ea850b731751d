#include "devo_evo/evolution/genome.h"

#include "devo_evo/soft_body/text.h"
#include "soft_body/sha256.h"

#include <algorithm>
#include <cmath>

namespace devo_evo
{
namespace
{
/// The half of the body at lower x becomes the mirror image of the other; a plane of voxels in the middle stays.
void mirror(std::vector<double>& values, const Lattice& lattice)
{
  for (int voxel = 0; voxel < lattice.voxelCount(); ++voxel)
  {
    const int image = lattice.mirrored(voxel);
    if (voxel < image)
    {
      values[voxel] = values[image];
    }
  }
}

/// What does not develop keeps its initial values.
void copyInitialToFinal(DevelopmentalProgram& program, Treatment treatment)
{
  if (!specOf(treatment).body_develops)
  {
    program.size_gene_final = program.size_gene_initial;
  }
  if (!specOf(treatment).control_develops)
  {
    program.phase_final = program.phase_initial;
  }
}

/// Mutates every mutation rate; without self-adaptation there are none.
void mutateRates(std::vector<double>& rates, const EvolutionSettings& settings, RandomStream& random)
{
  for (double& rate : rates)
  {
    rate = std::clamp(rate + settings.meta_mutation_sigma * random.normal(), settings.minimum_mutation_rate, 1.0);
  }
}

/// Which of the traits to mutate: each with probability 1 / count, and at least one.
std::vector<bool> selectTraits(size_t count, Profile profile, RandomStream& random)
{
  std::vector<bool> selected(count);
  const double probability = 1.0 / static_cast<double>(count);
  const auto any = [&selected] { return std::find(selected.begin(), selected.end(), true) != selected.end(); };
  do
  {
    for (size_t i = 0; i < count; ++i)
    {
      selected[i] = random.uniform() < probability;
    }
  } while (profile == Profile::RELEASED_CODE && !any());
  if (!any())
  {
    selected[random.below(count)] = true;
  }
  return selected;
}

void mutateValue(double& value, const TraitSpec& trait, RandomStream& random)
{
  value = std::clamp(value + trait.mutation_sigma * random.normal(), -trait.limit, trait.limit);
}

void mutateTrait(Genome& genome, const TraitSpec& trait, const EvolutionSettings& settings, const Lattice& lattice,
                 RandomStream& random)
{
  std::vector<double>& values = genome.program.*trait.values;
  for (size_t voxel = 0; voxel < values.size(); ++voxel)
  {
    const double rate = settings.mutation_rate ? *settings.mutation_rate : genome.mutation_rate[voxel];
    if (random.uniform() < rate)
    {
      mutateValue(values[voxel], trait, random);
    }
  }
  if (trait.mirrored)
  {
    mirror(values, lattice);
  }
}

/// "phase_final[17] is 0.5; " followed by the rule.
[[noreturn]] void refuse(const std::string& array, size_t voxel, double value, const std::string& rule)
{
  throw InvalidInput(array + "[" + toText(static_cast<int64_t>(voxel)) + "] is " + toText(value) + "; " + rule);
}

void validateTrait(const Genome& genome, const TraitSpec& trait, const Lattice& lattice)
{
  const std::vector<double>& values = genome.program.*trait.values;
  for (size_t voxel = 0; voxel < values.size(); ++voxel)
  {
    if (std::abs(values[voxel]) > trait.limit + GENE_TOLERANCE)
    {
      refuse(trait.name, voxel, values[voxel],
             "it must lie within " + toText(-trait.limit) + " to " + toText(trait.limit));
    }
    const int image = lattice.mirrored(static_cast<int>(voxel));
    if (trait.mirrored && values[voxel] != values[image])
    {
      refuse(trait.name, voxel, values[voxel],
             "it must equal its mirror image, [" + toText(image) + "], which is " + toText(values[image]));
    }
  }
}

void validateNoDevelopment(const std::string& name, const std::vector<double>& initial,
                           const std::vector<double>& final)
{
  for (size_t voxel = 0; voxel < initial.size(); ++voxel)
  {
    if (initial[voxel] != final[voxel])
    {
      refuse(name, voxel, final[voxel],
             "without development it must equal the initial value, which is " + toText(initial[voxel]));
    }
  }
}

void validateRates(const std::vector<double>& rates, const EvolutionSettings& settings, const SoftBodySettings& body)
{
  const int needed = settings.mutation_rate ? 0 : body.voxelCount();
  if (rates.size() != static_cast<size_t>(needed))
  {
    throw InvalidInput("mutation_rate has " + toText(static_cast<int64_t>(rates.size())) + " values; " +
                       (needed == 0 ? "with a fixed mutation rate it must have none"
                                    : "self-adaptation needs one per voxel, " + toText(needed)));
  }
  for (size_t voxel = 0; voxel < rates.size(); ++voxel)
  {
    if (!(rates[voxel] >= settings.minimum_mutation_rate && rates[voxel] <= 1.0))
    {
      refuse("mutation_rate", voxel, rates[voxel],
             "it must lie within " + toText(settings.minimum_mutation_rate) + " to 1");
    }
  }
}

void addProgram(Sha256& hash, const DevelopmentalProgram& program)
{
  hash.add(program.size_gene_initial).add(program.size_gene_final).add(program.phase_initial).add(program.phase_final);
}

Hash128 firstHalf(Sha256& hash)
{
  const std::array<uint8_t, 32> whole = hash.finish();
  Hash128 half;
  std::copy_n(whole.begin(), half.size(), half.begin());
  return half;
}
}  // namespace

bool Genome::operator==(const Genome& other) const
{
  return program == other.program && mutation_rate == other.mutation_rate;
}

std::vector<TraitSpec> evolvingTraits(const EvolutionSettings& settings)
{
  const double size_sigma = settings.size_mutation_sigma;
  const double phase_limit = settings.phaseLimit();
  const TreatmentSpec& treatment = specOf(settings.treatment);
  std::vector<TraitSpec> traits;
  traits.push_back({ "size_gene_initial", &DevelopmentalProgram::size_gene_initial, 1.0, size_sigma, true });
  if (treatment.body_develops)
  {
    traits.push_back({ "size_gene_final", &DevelopmentalProgram::size_gene_final, 1.0, size_sigma, true });
  }
  traits.push_back({ "phase_initial", &DevelopmentalProgram::phase_initial, phase_limit, phase_limit, false });
  if (treatment.control_develops)
  {
    traits.push_back({ "phase_final", &DevelopmentalProgram::phase_final, phase_limit, phase_limit, false });
  }
  return traits;
}

Genome randomGenome(const EvolutionSettings& settings, const Lattice& lattice, RandomStream& random)
{
  const size_t voxels = static_cast<size_t>(lattice.voxelCount());
  Genome genome;
  if (!settings.mutation_rate)
  {
    genome.mutation_rate.assign(voxels, settings.minimum_mutation_rate);
    if (settings.profile == Profile::RELEASED_CODE)
    {
      mutateRates(genome.mutation_rate, settings, random);
    }
  }
  for (const TraitSpec& trait : evolvingTraits(settings))
  {
    std::vector<double>& values = genome.program.*trait.values;
    values.resize(voxels);
    for (double& value : values)
    {
      value = random.uniform(-trait.limit, trait.limit);
    }
    if (trait.mirrored)
    {
      mirror(values, lattice);
    }
  }
  copyInitialToFinal(genome.program, settings.treatment);
  return genome;
}

Genome mutate(const Genome& parent, const EvolutionSettings& settings, const Lattice& lattice, RandomStream& random,
              MutationRecord* record)
{
  return mutateTraits(parent, evolvingTraits(settings), settings, lattice, random, record);
}

Genome mutateTraits(const Genome& parent, const std::vector<TraitSpec>& traits, const EvolutionSettings& settings,
                    const Lattice& lattice, RandomStream& random, MutationRecord* record)
{
  const std::vector<bool> selected = selectTraits(traits.size(), settings.profile, random);
  Genome child = parent;
  mutateRates(child.mutation_rate, settings, random);
  for (size_t i = 0; i < traits.size(); ++i)
  {
    if (selected[i])
    {
      mutateTrait(child, traits[i], settings, lattice, random);
      if (record)
      {
        record->traits.push_back(traits[i].name);
      }
    }
  }
  copyInitialToFinal(child.program, settings.treatment);
  return child;
}

Genome mutateOneVoxel(const Genome& parent, const std::vector<TraitSpec>& traits, const EvolutionSettings& settings,
                      const Lattice& lattice, RandomStream& random)
{
  const TraitSpec& trait = traits[random.below(traits.size())];
  std::vector<int> candidates;
  for (int voxel = 0; voxel < lattice.voxelCount(); ++voxel)
  {
    if (!trait.mirrored || voxel >= lattice.mirrored(voxel))
    {
      candidates.push_back(voxel);
    }
  }
  Genome child = parent;
  std::vector<double>& values = child.program.*trait.values;
  mutateValue(values[static_cast<size_t>(candidates[random.below(candidates.size())])], trait, random);
  if (trait.mirrored)
  {
    mirror(values, lattice);
  }
  copyInitialToFinal(child.program, settings.treatment);
  return child;
}

Genome bornGenome(const EvolutionSettings& settings, const Lattice& lattice, int64_t trial, int64_t generation,
                  int64_t id, const Genome* parent)
{
  if (!parent && generation == 0 && settings.founders && id < static_cast<int64_t>(settings.founders->size()))
  {
    return settings.founders->at(static_cast<size_t>(id));
  }
  const RandomPurpose purpose = parent ? RandomPurpose::MUTATION : RandomPurpose::FOUNDER_GENOME;
  RandomStream random(settings.seed, settings.arm(), trial, generation, id, purpose);
  return parent ? mutate(*parent, settings, lattice, random) : randomGenome(settings, lattice, random);
}

void validate(const Genome& genome, const EvolutionSettings& settings, const SoftBodySettings& body)
{
  const DevelopmentalProgram& program = genome.program;
  validate(program, body);
  const Lattice lattice(body);
  for (const TraitSpec& trait : evolvingTraits(settings))
  {
    validateTrait(genome, trait, lattice);
  }
  if (!specOf(settings.treatment).body_develops)
  {
    validateNoDevelopment("size_gene_final", program.size_gene_initial, program.size_gene_final);
  }
  if (!specOf(settings.treatment).control_develops)
  {
    validateNoDevelopment("phase_final", program.phase_initial, program.phase_final);
  }
  validateRates(genome.mutation_rate, settings, body);
}

Hash128 phenotypeHash(const DevelopmentalProgram& program)
{
  Sha256 hash;
  addProgram(hash, program);
  return firstHalf(hash);
}

Hash128 genomeHash(const Genome& genome)
{
  Sha256 hash;
  addProgram(hash, genome.program);
  hash.add(genome.mutation_rate);
  return firstHalf(hash);
}

std::string toHex(const Hash128& hash)
{
  std::string digits;
  for (const uint8_t byte : hash)
  {
    digits += "0123456789abcdef"[byte >> 4];
    digits += "0123456789abcdef"[byte & 0xf];
  }
  return digits;
}
}  // namespace devo_evo
