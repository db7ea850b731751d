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
void mirror(std::vector<double>& values, const std::vector<int>& image)
{
  for (size_t i = 0; i < image.size(); ++i)
  {
    const auto other = static_cast<size_t>(image[i]);
    if (i < other)
    {
      values[i] = values[other];
    }
  }
}

/// What does not develop keeps its initial values.
void copyInitialToFinal(DevelopmentalProgram& program, const GenomeLayout& layout)
{
  if (!layout.morphology.develops)
  {
    program.morphology_final = program.morphology_initial;
  }
  if (!layout.control.develops)
  {
    program.control_final = program.control_initial;
  }
}

bool isMorphology(const TraitSpec& trait)
{
  return trait.values == &DevelopmentalProgram::morphology_initial ||
         trait.values == &DevelopmentalProgram::morphology_final;
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
  value = std::clamp(value + trait.mutation_sigma * random.normal(), trait.minimum, trait.maximum);
}

/// @param rate_of gives the probability with which the number at an index mutates.
template <class Rate>
void mutateTrait(Genome& genome, const TraitSpec& trait, Rate rate_of, RandomStream& random)
{
  std::vector<double>& values = genome.program.*trait.values;
  for (size_t i = 0; i < values.size(); ++i)
  {
    if (random.uniform() < rate_of(i))
    {
      mutateValue(values[i], trait, random);
    }
  }
  mirror(values, trait.image);
}

/// How many numbers of a part evolve.
double evolvingNumbers(const GenomePart& part)
{
  return static_cast<double>(part.size) * (part.develops ? 2.0 : 1.0);
}

/// One number of each part on average.
Genome mutateEveryPart(const Genome& parent, const GenomeLayout& layout, RandomStream& random, MutationRecord* record)
{
  Genome child = parent;
  for (const TraitSpec& trait : evolvingTraits(layout))
  {
    const double rate = 1.0 / evolvingNumbers(isMorphology(trait) ? layout.morphology : layout.control);
    mutateTrait(
        child, trait, [rate](size_t) { return rate; }, random);
    if (record && child.program.*trait.values != parent.program.*trait.values)
    {
      record->traits.push_back(trait.name);
    }
  }
  copyInitialToFinal(child.program, layout);
  return child;
}

/// "phase_final[17] is 0.5; " followed by the rule.
[[noreturn]] void refuse(const std::string& array, size_t voxel, double value, const std::string& rule)
{
  throw InvalidInput(array + "[" + toText(static_cast<int64_t>(voxel)) + "] is " + toText(value) + "; " + rule);
}

void validateArray(const std::string& name, const std::vector<double>& values, const GenomePart& part,
                   const std::string& carrier)
{
  if (values.size() != part.size)
  {
    throw InvalidInput(name + " has " + toText(static_cast<int64_t>(values.size())) + " values; " + carrier +
                       " needs " + toText(static_cast<int64_t>(part.size)));
  }
  for (size_t i = 0; i < values.size(); ++i)
  {
    if (!(values[i] >= part.lowest - GENE_TOLERANCE && values[i] <= part.highest + GENE_TOLERANCE))
    {
      refuse(name, i, values[i], "it must lie within " + toText(part.lowest) + " to " + toText(part.highest));
    }
  }
}

void validateTrait(const Genome& genome, const TraitSpec& trait)
{
  const std::vector<double>& values = genome.program.*trait.values;
  for (size_t i = 0; i < values.size(); ++i)
  {
    if (values[i] < trait.minimum - GENE_TOLERANCE || values[i] > trait.maximum + GENE_TOLERANCE)
    {
      refuse(trait.name, i, values[i], "it must lie within " + toText(trait.minimum) + " to " + toText(trait.maximum));
    }
    if (!trait.mirrored())
    {
      continue;
    }
    const int image = trait.image[i];
    if (values[i] != values[static_cast<size_t>(image)])
    {
      refuse(trait.name, i, values[i],
             "it must equal its mirror image, [" + toText(image) + "], which is " +
                 toText(values[static_cast<size_t>(image)]));
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

void validateRates(const std::vector<double>& rates, const EvolutionSettings& settings, const GenomeLayout& layout)
{
  const size_t needed = layout.self_adaptive ? layout.morphology.size : 0;
  if (rates.size() != needed)
  {
    throw InvalidInput("mutation_rate has " + toText(static_cast<int64_t>(rates.size())) + " values; " +
                       (needed == 0 ? "with a fixed mutation rate it must have none"
                                    : "self-adaptation needs one per " + layout.morphology.place + ", " +
                                          toText(static_cast<int64_t>(needed))));
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
  hash.add(program.morphology_initial)
      .add(program.morphology_final)
      .add(program.control_initial)
      .add(program.control_final);
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

std::vector<TraitSpec> evolvingTraits(const GenomeLayout& layout)
{
  using Program = DevelopmentalProgram;
  std::vector<TraitSpec> traits;
  const auto add =
      [&traits](const GenomePart& part, std::vector<double> Program::*initial, std::vector<double> Program::*final)
  {
    traits.push_back({ part.initialName(), initial, part.minimum, part.maximum, part.mutation_sigma, part.image });
    if (part.develops)
    {
      traits.push_back({ part.finalName(), final, part.minimum, part.maximum, part.mutation_sigma, part.image });
    }
  };
  add(layout.morphology, &Program::morphology_initial, &Program::morphology_final);
  add(layout.control, &Program::control_initial, &Program::control_final);
  return traits;
}

Genome randomGenome(const EvolutionSettings& settings, const GenomeLayout& layout, RandomStream& random)
{
  Genome genome;
  if (layout.self_adaptive)
  {
    genome.mutation_rate.assign(layout.morphology.size, settings.minimum_mutation_rate);
    if (settings.profile == Profile::RELEASED_CODE)
    {
      mutateRates(genome.mutation_rate, settings, random);
    }
  }
  for (const TraitSpec& trait : evolvingTraits(layout))
  {
    std::vector<double>& values = genome.program.*trait.values;
    values.resize(isMorphology(trait) ? layout.morphology.size : layout.control.size);
    for (double& value : values)
    {
      value = random.uniform(trait.minimum, trait.maximum);
    }
    mirror(values, trait.image);
  }
  copyInitialToFinal(genome.program, layout);
  return genome;
}

Genome mutate(const Genome& parent, const EvolutionSettings& settings, const GenomeLayout& layout, RandomStream& random,
              MutationRecord* record)
{
  return layout.mutation == MutationOperator::EVERY_PART
             ? mutateEveryPart(parent, layout, random, record)
             : mutateTraits(parent, evolvingTraits(layout), settings, layout, random, record);
}

Genome mutateTraits(const Genome& parent, const std::vector<TraitSpec>& traits, const EvolutionSettings& settings,
                    const GenomeLayout& layout, RandomStream& random, MutationRecord* record)
{
  const std::vector<bool> selected = selectTraits(traits.size(), settings.profile, random);
  Genome child = parent;
  mutateRates(child.mutation_rate, settings, random);
  const auto rate_of = [&](size_t i)
  { return settings.mutation_rate ? *settings.mutation_rate : child.mutation_rate[i]; };
  for (size_t i = 0; i < traits.size(); ++i)
  {
    if (selected[i])
    {
      mutateTrait(child, traits[i], rate_of, random);
      if (record)
      {
        record->traits.push_back(traits[i].name);
      }
    }
  }
  copyInitialToFinal(child.program, layout);
  return child;
}

Genome mutateOneVoxel(const Genome& parent, const std::vector<TraitSpec>& traits, const GenomeLayout& layout,
                      RandomStream& random)
{
  const TraitSpec& trait = traits[random.below(traits.size())];
  Genome child = parent;
  std::vector<double>& values = child.program.*trait.values;
  std::vector<size_t> candidates;
  for (size_t i = 0; i < values.size(); ++i)
  {
    if (!trait.mirrored() || i >= static_cast<size_t>(trait.image[i]))
    {
      candidates.push_back(i);
    }
  }
  mutateValue(values[candidates[random.below(candidates.size())]], trait, random);
  mirror(values, trait.image);
  copyInitialToFinal(child.program, layout);
  return child;
}

Genome bornGenome(const EvolutionSettings& settings, const GenomeLayout& layout, int64_t trial, int64_t generation,
                  int64_t id, const Genome* parent)
{
  if (!parent && generation == 0 && settings.founders && id < static_cast<int64_t>(settings.founders->size()))
  {
    return settings.founders->at(static_cast<size_t>(id));
  }
  const RandomPurpose purpose = parent ? RandomPurpose::MUTATION : RandomPurpose::FOUNDER_GENOME;
  RandomStream random(settings.seed, layout.arm, trial, generation, id, purpose);
  return parent ? mutate(*parent, settings, layout, random) : randomGenome(settings, layout, random);
}

void validate(const DevelopmentalProgram& program, const GenomeLayout& layout)
{
  const GenomePart& morphology = layout.morphology;
  const GenomePart& control = layout.control;
  validateArray(morphology.initialName(), program.morphology_initial, morphology, layout.carrier);
  validateArray(morphology.finalName(), program.morphology_final, morphology, layout.carrier);
  validateArray(control.initialName(), program.control_initial, control, layout.carrier);
  validateArray(control.finalName(), program.control_final, control, layout.carrier);
}

void validate(const Genome& genome, const EvolutionSettings& settings, const GenomeLayout& layout)
{
  const DevelopmentalProgram& program = genome.program;
  validate(program, layout);
  for (const TraitSpec& trait : evolvingTraits(layout))
  {
    validateTrait(genome, trait);
  }
  if (!layout.morphology.develops)
  {
    validateNoDevelopment(layout.morphology.finalName(), program.morphology_initial, program.morphology_final);
  }
  if (!layout.control.develops)
  {
    validateNoDevelopment(layout.control.finalName(), program.control_initial, program.control_final);
  }
  validateRates(genome.mutation_rate, settings, layout);
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
