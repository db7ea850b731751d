#include "devo_evo/verification/compare.h"

#include "devo_evo/experiment/parameters.h"
#include "devo_evo/soft_body/text.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace devo_evo
{
namespace
{
using Fields = std::vector<FieldDifference>;

void compare(Fields& fields, const std::string& name, const std::string& a, const std::string& b)
{
  if (a != b)
  {
    fields.push_back({ name, a, b });
  }
}

std::string textOf(double number)
{
  return toText(number + 0.0);
}

Fields compareParameters(const ExperimentSettings& a, const ExperimentSettings& b)
{
  Parameters ours, theirs;
  ours.experiment = a;
  theirs.experiment = b;
  Fields fields;
  for (const ParameterSpec& spec : parameterSpecs())
  {
    if (describesExperiment(spec, a.body.kind) || describesExperiment(spec, b.body.kind))
    {
      compare(fields, spec.name, spec.get(ours), spec.get(theirs));
    }
  }
  const auto founders = [](const ExperimentSettings& settings)
  {
    if (!settings.evolution.founders)
    {
      return std::string("random");
    }
    std::string hashes;
    for (const Genome& founder : *settings.evolution.founders)
    {
      hashes += (hashes.empty() ? "" : " ") + toHex(genomeHash(founder));
    }
    return hashes;
  };
  compare(fields, "founders", founders(a), founders(b));
  return fields;
}

Fields compareProvenance(const std::vector<Start>& a, const std::vector<Start>& b)
{
  Fields fields;
  compare(fields, "starts", toText(static_cast<int64_t>(a.size())), toText(static_cast<int64_t>(b.size())));
  const Provenance ours = a.empty() ? Provenance() : a.back().provenance;
  const Provenance theirs = b.empty() ? Provenance() : b.back().provenance;
  compare(fields, "version", ours.version, theirs.version);
  compare(fields, "compiler", ours.compiler, theirs.compiler);
  compare(fields, "processor", ours.processor, theirs.processor);
  compare(fields, "instruction_set", ours.instruction_set, theirs.instruction_set);
  compare(fields, "host", ours.host, theirs.host);
  compare(fields, "ros", ours.ros, theirs.ros);
  compare(fields, "engine_fingerprint", hashToString(ours.engine_fingerprint), hashToString(theirs.engine_fingerprint));
  return fields;
}

Fields compareIndividuals(const ArchivedIndividual& a, const ArchivedIndividual& b, const Body& body)
{
  Fields fields;
  const auto parent = [](const ArchivedIndividual& archived)
  { return archived.individual.parent == Individual::NO_PARENT ? "none" : toText(archived.individual.parent); };
  const Evaluation& ours = a.individual.evaluation.value();
  const Evaluation& theirs = b.individual.evaluation.value();
  compare(fields, "parent", parent(a), parent(b));
  compare(fields, "age", toText(a.individual.age), toText(b.individual.age));
  compare(fields, "genome_hash", toHex(a.genome_hash), toHex(b.genome_hash));
  compare(fields, "phenotype_hash", toHex(a.phenotype_hash), toHex(b.phenotype_hash));
  compare(fields, "morphology_window", textOf(a.morphology_window), textOf(b.morphology_window));
  compare(fields, "control_window", textOf(a.control_window), textOf(b.control_window));
  compare(fields, "valid", ours.valid ? "true" : "false", theirs.valid ? "true" : "false");
  compare(fields, "fitness", textOf(ours.fitness), textOf(theirs.fitness));
  for (const Measure& measure : body.measures())
  {
    const auto text = [&measure](const Evaluation& evaluation)
    {
      const double value = measure.get(evaluation);
      return std::isnan(value) && measure.may_lack ? "none" : textOf(value);
    };
    compare(fields, measure.name, text(ours), text(theirs));
  }
  compare(fields, "state_hash", hashToString(ours.state_hash), hashToString(theirs.state_hash));
  return fields;
}

/// "3 of 48 differ, first [17] = 0.5"
void compareArrays(Fields& fields, const std::string& name, const std::vector<double>& a, const std::vector<double>& b)
{
  const auto [first, other] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  if (first == a.end() || other == b.end())
  {
    compare(fields, name, toText(static_cast<int64_t>(a.size())) + " values",
            toText(static_cast<int64_t>(b.size())) + " values");
    return;
  }
  int64_t count = 0;
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    count += a[i] != b[i] ? 1 : 0;
  }
  const std::string place =
      name + "[" + toText(static_cast<int64_t>(first - a.begin())) + "] (the first of " + toText(count) + ")";
  fields.push_back({ place, toText(*first), toText(*other) });
}

Fields compareGenomes(const ArchivedIndividual& a, const ArchivedIndividual& b, const GenomeLayout& layout)
{
  Fields fields;
  if (a.has_genome && b.has_genome)
  {
    const DevelopmentalProgram& ours = a.individual.genome.program;
    const DevelopmentalProgram& theirs = b.individual.genome.program;
    compareArrays(fields, layout.morphology.initialName(), ours.morphology_initial, theirs.morphology_initial);
    compareArrays(fields, layout.morphology.finalName(), ours.morphology_final, theirs.morphology_final);
    compareArrays(fields, layout.control.initialName(), ours.control_initial, theirs.control_initial);
    compareArrays(fields, layout.control.finalName(), ours.control_final, theirs.control_final);
    compareArrays(fields, "mutation_rate", a.individual.genome.mutation_rate, b.individual.genome.mutation_rate);
  }
  return fields;
}

Fields compareSelections(const ArchivedSelection& a, const ArchivedSelection& b)
{
  Fields fields;
  const size_t most = std::max(a.survivors.size(), b.survivors.size());
  for (size_t rank = 0; rank < most && fields.empty(); ++rank)
  {
    const auto at = [rank](const ArchivedSelection& selection)
    { return rank < selection.survivors.size() ? toText(selection.survivors[rank]) : "none"; };
    compare(fields, "survivor of rank " + toText(static_cast<int64_t>(rank) + 1), at(a), at(b));
  }
  compare(fields, "champion", toText(a.champion), toText(b.champion));
  compare(fields, "best_fitness", textOf(a.best_fitness), textOf(b.best_fitness));
  compare(fields, "median_fitness", textOf(a.median_fitness), textOf(b.median_fitness));
  return fields;
}

/// Reads a trial's individuals by id, a page at a time.
class Rows
{
public:
  Rows(const Archive& archive, int64_t trial) : archive_(archive), trial_(trial) { turnPage(); }

  std::vector<ArchivedIndividual> bornIn(int64_t generation)
  {
    std::vector<ArchivedIndividual> born;
    while (next_ < page_.size() && page_[next_].individual.generation == generation)
    {
      born.push_back(std::move(page_[next_++]));
      if (next_ == page_.size())
      {
        turnPage();
      }
    }
    return born;
  }

private:
  static constexpr int64_t PAGE = 256;

  void turnPage()
  {
    page_ = archive_.readIndividuals(trial_, first_id_, PAGE);
    first_id_ += PAGE;
    next_ = 0;
  }

  const Archive& archive_;
  const int64_t trial_;
  std::vector<ArchivedIndividual> page_;
  size_t next_ = 0;
  int64_t first_id_ = 0;
};

/// The first difference of a trial, if there is one before the shorter of both ends.
class TrialComparison
{
public:
  TrialComparison(const Archive& a, const Archive& b, int64_t trial)
    : a_(a), b_(b), body_(makeBody(a.settings().body)), trial_(trial), rows_a_(a, trial), rows_b_(b, trial)
  {
  }

  std::optional<TrialDifference> generation(int64_t generation)
  {
    const auto born_a = rows_a_.bornIn(generation);
    const auto born_b = rows_b_.bornIn(generation);
    for (size_t i = 0; i < std::min(born_a.size(), born_b.size()); ++i)
    {
      const int64_t id = born_a[i].individual.id;
      Fields fields = id == born_b[i].individual.id ? compareIndividuals(born_a[i], born_b[i], *body_)
                                                    : Fields{ { "id", toText(id), toText(born_b[i].individual.id) } };
      if (!fields.empty())
      {
        const Fields arrays = compareGenomes(a_.readIndividual(trial_, id), b_.readIndividual(trial_, id),
                                             body_->layout(a_.settings().evolution));
        fields.insert(fields.end(), arrays.begin(), arrays.end());
        return TrialDifference{ trial_, generation, id, fields };
      }
    }
    Fields fields;
    compare(fields, "newcomers", toText(static_cast<int64_t>(born_a.size())),
            toText(static_cast<int64_t>(born_b.size())));
    const Fields selections = compareSelections(a_.readSelection(trial_, generation).value_or(ArchivedSelection()),
                                                b_.readSelection(trial_, generation).value_or(ArchivedSelection()));
    fields.insert(fields.end(), selections.begin(), selections.end());
    return fields.empty() ? std::nullopt
                          : std::optional<TrialDifference>(TrialDifference{ trial_, generation, -1, fields });
  }

private:
  const Archive& a_;
  const Archive& b_;
  const std::shared_ptr<const Body> body_;
  const int64_t trial_;
  Rows rows_a_;
  Rows rows_b_;
};

void compareTrial(ArchiveComparison& comparison, const Archive& a, const Archive& b, int64_t trial, int64_t generations)
{
  TrialComparison trials(a, b, trial);
  for (int64_t generation = 0; generation < generations; ++generation)
  {
    if (auto difference = trials.generation(generation))
    {
      comparison.trials.push_back(*std::move(difference));
      return;
    }
    ++comparison.equal_generations;
  }
}
}  // namespace

ArchiveComparison compareArchives(const Archive& a, const Archive& b)
{
  ArchiveComparison comparison;
  comparison.parameters = compareParameters(a.settings(), b.settings());
  comparison.provenance = compareProvenance(a.starts(), b.starts());
  if (a.settings().body.kind != b.settings().body.kind)
  {
    return comparison;  // robots of different kinds have nothing to compare
  }
  const auto trials_a = a.trials();
  const auto trials_b = b.trials();
  std::set<int64_t> trials(trials_a.begin(), trials_a.end());
  trials.insert(trials_b.begin(), trials_b.end());
  for (const int64_t trial : trials)
  {
    const auto generations = [trial](const Archive& archive, const std::vector<int64_t>& present)
    {
      const bool there = std::binary_search(present.begin(), present.end(), trial);
      return there ? archive.extentOf(trial).last_generation + 1 : 0;
    };
    const ExtentDifference extent = { trial, generations(a, trials_a), generations(b, trials_b) };
    if (extent.generations_a != extent.generations_b)
    {
      comparison.extents.push_back(extent);
    }
    compareTrial(comparison, a, b, trial, std::min(extent.generations_a, extent.generations_b));
  }
  return comparison;
}
}  // namespace devo_evo
