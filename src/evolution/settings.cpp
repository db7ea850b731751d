#include "devo_evo/evolution/settings.h"

#include "devo_evo/evolution/genome.h"
#include "devo_evo/soft_body/text.h"
#include "soft_body/check_ranges.h"

#include <algorithm>
#include <iterator>

namespace devo_evo
{
const TreatmentSpec& specOf(Treatment treatment)
{
  return *std::find_if(std::begin(TREATMENTS), std::end(TREATMENTS),
                       [=](const TreatmentSpec& spec) { return spec.treatment == treatment; });
}

std::string treatmentNames()
{
  std::string names;
  for (const TreatmentSpec& spec : TREATMENTS)
  {
    const bool last = &spec == std::end(TREATMENTS) - 1;
    names += (names.empty() ? "" : last ? " or " : ", ") + std::string(spec.name);
  }
  return names;
}

std::string toString(Treatment treatment)
{
  return specOf(treatment).name;
}

std::string toString(Selection selection)
{
  return selection == Selection::AFPO ? "afpo" : selection == Selection::NEUTRAL ? "neutral" : "random_search";
}

std::string toString(Profile profile)
{
  return profile == Profile::PAPER ? "paper" : "released_code";
}

Treatment parseTreatment(const std::string& name)
{
  for (const TreatmentSpec& spec : TREATMENTS)
  {
    if (name == spec.name)
    {
      return spec.treatment;
    }
  }
  throw InvalidInput("treatment is \"" + name + "\"; it must be " + treatmentNames());
}

Profile parseProfile(const std::string& name)
{
  for (const Profile profile : { Profile::PAPER, Profile::RELEASED_CODE })
  {
    if (name == toString(profile))
    {
      return profile;
    }
  }
  throw InvalidInput("profile is \"" + name + "\"; it must be paper or released_code");
}

Selection parseSelection(const std::string& name)
{
  for (const Selection selection : { Selection::AFPO, Selection::NEUTRAL, Selection::RANDOM_SEARCH })
  {
    if (name == toString(selection))
    {
      return selection;
    }
  }
  throw InvalidInput("selection is \"" + name + "\"; it must be afpo, neutral or random_search");
}

const std::vector<BoundedField<EvolutionSettings, int>>& evolutionIntegers()
{
  static const std::vector<BoundedField<EvolutionSettings, int>> fields = {
    { "population", &EvolutionSettings::population, 2, 10000 },
    { "random_injections", &EvolutionSettings::random_injections, 0, 1000 },
  };
  return fields;
}

const std::vector<BoundedField<EvolutionSettings, double>>& evolutionReals()
{
  static const std::vector<BoundedField<EvolutionSettings, double>> fields = {
    { "size_mutation_sigma", &EvolutionSettings::size_mutation_sigma, 0.0, 10.0 },
    { "meta_mutation_sigma", &EvolutionSettings::meta_mutation_sigma, 0.0, 1.0 },
    { "minimum_mutation_rate", &EvolutionSettings::minimum_mutation_rate, 0.0, 1.0 },
    { "rigid_mutation_sigma", &EvolutionSettings::rigid_mutation_sigma, 0.0, 10.0 },
  };
  return fields;
}

double EvolutionSettings::phaseLimit() const
{
  return profile == Profile::PAPER ? 0.25 : 1.0;
}

std::string EvolutionSettings::arm() const
{
  // Adding 0.0 turns -0.0 into 0.0: equal rates, equal names.
  const std::string rate = mutation_rate ? toText(*mutation_rate + 0.0) : "self_adaptive";
  const std::string baseline = selection == Selection::AFPO ? "" : "/" + toString(selection);
  return toString(treatment) + "/" + toString(profile) + "/" + rate + baseline;
}

void EvolutionSettings::validate() const
{
  if (mutation_rate && !(*mutation_rate >= 0.0 && *mutation_rate <= 1.0))
  {
    throw InvalidInput("mutation_rate is " + toText(*mutation_rate) +
                       "; it must be self_adaptive or lie within 0 to 1");
  }
  checkRanges(*this, evolutionIntegers());
  if (seed < 0)
  {
    throw InvalidInput("seed is " + toText(seed) + "; it must lie within 0 to " + toText(INT64_MAX));
  }
  checkRanges(*this, evolutionReals());
  if (founders && founders->size() > static_cast<size_t>(population))
  {
    throw InvalidInput("there are " + toText(static_cast<int64_t>(founders->size())) +
                       " founders; the population must be at least as large, and is " + toText(population));
  }
}
}  // namespace devo_evo
