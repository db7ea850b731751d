#include "verification/trial_replay.h"

#include "devo_evo/soft_body/text.h"

#include <cmath>

namespace devo_evo
{
namespace
{
std::string textOf(double number)
{
  return toText(number);
}

std::string textOf(int64_t number)
{
  return toText(number);
}

std::string textOf(bool value)
{
  return value ? "true" : "false";
}

std::string textOf(const Hash128& hash)
{
  return toHex(hash);
}

/// SQLite does not keep the sign of zero; what is not a number equals what is not one.
bool same(double archived, double repeated)
{
  return archived == repeated || (std::isnan(archived) && std::isnan(repeated));
}

template <class Value>
bool same(const Value& archived, const Value& repeated)
{
  return archived == repeated;
}

/// Throws offences against one individual.
class Comparison
{
public:
  explicit Comparison(const Individual& individual)
    : trial_(individual.trial), generation_(individual.generation), id_(individual.id)
  {
  }

  template <class Value>
  void check(const std::string& name, const Value& archived, const Value& repeated, const std::string& by) const
  {
    if (!same(archived, repeated))
    {
      fail(name + " is " + textOf(archived) + " in the archive, but " + textOf(repeated) + " by " + by);
    }
  }

  [[noreturn]] void fail(const std::string& what) const { throw Offence{ trial_, generation_, id_, what }; }

private:
  int64_t trial_;
  int64_t generation_;
  int64_t id_;
};

[[noreturn]] void failTrial(int64_t trial, int64_t generation, const std::string& what)
{
  throw Offence{ trial, generation, -1, what };
}

std::string listed(const std::vector<int64_t>& ids)
{
  std::string list;
  for (const int64_t id : ids)
  {
    list += (list.empty() ? "" : " ") + toText(id);
  }
  return list;
}

}  // namespace

TrialReplay::TrialReplay(const Archive& archive, const ExperimentSettings& settings, int64_t trial)
  : archive_(archive)
  , settings_(settings)
  , extent_(archive.extentOf(trial))
  , body_(makeBody(settings.body))
  , layout_(body_->layout(settings.evolution))
  , trial_(settings.evolution, *body_, trial)
{
}

std::vector<ArchivedIndividual> TrialReplay::nextGeneration()
{
  const int64_t first_id = begun_ ? trial_.nextId() : 0;
  if (begun_)
  {
    trial_.breed();
  }
  begun_ = true;
  selected_ = false;
  std::vector<ArchivedIndividual> rows =
      archive_.readIndividuals(trial_.number(), first_id, trial_.nextId() - first_id);
  std::vector<ArchivedIndividual> newcomers;
  auto row = rows.begin();
  for (const int64_t id : trial_.awaiting())
  {
    const bool present = row != rows.end() && row->individual.id == id;
    newcomers.push_back(compareBirth(trial_.individual(id), present ? &*row : nullptr));
    row += present ? 1 : 0;
  }
  for (const ArchivedIndividual& newcomer : newcomers)
  {
    setEvaluation(newcomer.individual);
  }
  candidates_ = trial_.individuals();
  return newcomers;
}

void TrialReplay::setEvaluation(const Individual& archived)
{
  try
  {
    trial_.setEvaluation(archived.id, archived.evaluation.value());
  }
  catch (const InvalidInput& error)
  {
    Comparison(archived).fail(error.what());
  }
}

ArchivedIndividual TrialReplay::compareBirth(const Individual& born, const ArchivedIndividual* archived)
{
  const Comparison comparison(born);
  if (!archived)
  {
    comparison.fail("this individual is missing; it was born in generation " + toText(born.generation));
  }
  const std::string rule = "the rules of birth";
  const Individual& noted = archived->individual;
  comparison.check("parent", noted.parent, born.parent, rule);
  comparison.check("generation", noted.generation, born.generation, rule);
  comparison.check("age", noted.age, born.age, rule);
  comparison.check("genome_hash", archived->genome_hash, genomeHash(born.genome), rule);
  comparison.check("phenotype_hash", archived->phenotype_hash, phenotypeHash(born.genome.program), rule);
  comparison.check("morphology_window", archived->morphology_window, morphologyWindow(born.genome.program, layout_),
                   "the genome");
  comparison.check("control_window", archived->control_window, controlWindow(born.genome.program, layout_),
                   "the genome");
  if (archived->has_genome && !(noted.genome == born.genome))
  {
    comparison.fail("the stored genome is not the one it was born with, which has the hash " +
                    toHex(archived->genome_hash) + ", but one with " + toHex(genomeHash(noted.genome)));
  }
  stored_genomes_ += archived->has_genome ? 1 : 0;
  try
  {
    body_->validate(noted.evaluation.value());
    validate(born.genome, settings_.evolution, layout_);
  }
  catch (const InvalidInput& error)
  {
    comparison.fail(error.what());
  }
  const auto twin = archive_.findEvaluation(archived->phenotype_hash);
  if (!twin || !same(twin->fitness, noted.evaluation->fitness) || twin->state_hash != noted.evaluation->state_hash)
  {
    comparison.fail("another individual of the same phenotype has another fitness or state hash");
  }
  ArchivedIndividual whole = *archived;
  whole.individual.genome = born.genome;
  whole.has_genome = true;
  return whole;
}

void TrialReplay::select()
{
  const GenerationRecord record = trial_.select();
  selected_ = true;
  survivor_rows_ += static_cast<int64_t>(record.survivors.size());
  compareSelection(record);
  if (!finished())
  {
    return;
  }
  if (extent_.individuals != trial_.nextId())
  {
    failTrial(record.trial, record.generation,
              "the archive has " + toText(extent_.individuals) + " individuals of this trial, but " +
                  toText(trial_.nextId()) + " were born");
  }
  if (extent_.survivors != survivor_rows_)
  {
    failTrial(record.trial, record.generation,
              "the archive has " + toText(extent_.survivors) + " survivors of this trial over all generations, but " +
                  toText(survivor_rows_) + " were selected");
  }
}

void TrialReplay::compareSelection(const GenerationRecord& record) const
{
  const auto archived = archive_.readSelection(record.trial, record.generation);
  if (!archived)
  {
    failTrial(record.trial, record.generation, "this generation is missing");
  }
  if (archived->survivors != record.survivors)
  {
    failTrial(record.trial, record.generation,
              "the survivors do not follow from the selection rule: the archive has " + listed(archived->survivors) +
                  "; selected are " + listed(record.survivors));
  }
  const auto check = [&](const std::string& name, const auto& noted, const auto& selected)
  {
    if (!same(noted, selected))
    {
      failTrial(record.trial, record.generation,
                name + " is " + textOf(noted) + " in the archive, but " + textOf(selected) + " by the selection rule");
    }
  };
  check("champion", archived->champion, record.champion);
  check("best_fitness", archived->best_fitness, record.best_fitness);
  check("median_fitness", archived->median_fitness, record.median_fitness);
}

void compareLife(const Individual& individual, const Evaluation& repeated, const Body& body)
{
  const Comparison comparison(individual);
  const Evaluation& archived = individual.evaluation.value();
  const std::string by = "simulating it again";
  comparison.check("valid", archived.valid, repeated.valid, by);
  comparison.check("fitness", archived.fitness, repeated.fitness, by);
  for (const Measure& measure : body.measures())
  {
    comparison.check(measure.name, measure.get(archived), measure.get(repeated), by);
  }
  if (archived.state_hash != repeated.state_hash)
  {
    comparison.fail("state_hash is " + hashToString(archived.state_hash) + " in the archive, but " +
                    hashToString(repeated.state_hash) + " by " + by);
  }
  for (const Measure& measure : body.failureMeasures())
  {
    comparison.check(measure.name, measure.get(archived), measure.get(repeated), by);
  }
}
}  // namespace devo_evo
