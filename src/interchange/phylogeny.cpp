#include "devo_evo/interchange/phylogeny.h"

#include "devo_evo/soft_body/text.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace devo_evo
{
namespace
{
constexpr int64_t PAGE = 1000;

/// The last generation whose selection each survived.
std::map<int64_t, int64_t> lastSurvived(const Archive& archive, int64_t trial, int64_t last_generation)
{
  std::map<int64_t, int64_t> last;
  for (int64_t generation = 0; generation <= last_generation; ++generation)
  {
    for (const int64_t id : archive.readSelection(trial, generation).value_or(ArchivedSelection()).survivors)
    {
      last[id] = generation;
    }
  }
  return last;
}

std::vector<Descendant> withDeaths(const Archive& archive, int64_t trial, std::vector<ArchivedIndividual> individuals)
{
  const int64_t last_generation = archive.extentOf(trial).last_generation;
  const auto last = lastSurvived(archive, trial, last_generation);
  std::vector<Descendant> descendants;
  descendants.reserve(individuals.size());
  for (ArchivedIndividual& archived : individuals)
  {
    const auto survived = last.find(archived.individual.id);
    const int64_t death = survived == last.end() ? archived.individual.generation : survived->second + 1;
    descendants.push_back(
        { std::move(archived), death > last_generation ? std::nullopt : std::optional<int64_t>(death) });
  }
  return descendants;
}

std::string textOf(double number)
{
  return std::isnan(number) ? "" : toText(number);
}

std::string parentOf(const Individual& individual)
{
  return individual.parent == Individual::NO_PARENT ? "" : toText(individual.parent);
}

/// A column of a table: its name, and its value for each individual.
struct Column
{
  std::string name;
  std::function<std::string(const ArchivedIndividual&)> value;
};

Column measure(const Measure& measure)
{
  return { measure.name, [measure](const ArchivedIndividual& archived)
           {
             const double value = measure.get(archived.individual.evaluation.value());
             return measure.whole && !std::isnan(value) ? toText(static_cast<int64_t>(value)) : textOf(value);
           } };
}

/// What a robot is and did: as the columns of the archive.
std::vector<Column> traits(const Body& body)
{
  std::vector<Column> columns = {
    { "age", [](const ArchivedIndividual& archived) { return toText(archived.individual.age); } },
    { "valid", [](const ArchivedIndividual& archived) { return archived.individual.evaluation->valid ? "1" : "0"; } },
    { "fitness", [](const ArchivedIndividual& archived) { return textOf(archived.individual.evaluation->fitness); } },
  };
  for (const Measure& each : body.measures())
  {
    columns.push_back(measure(each));
  }
  columns.push_back(
      { "morphology_window", [](const ArchivedIndividual& archived) { return textOf(archived.morphology_window); } });
  columns.push_back(
      { "control_window", [](const ArchivedIndividual& archived) { return textOf(archived.control_window); } });
  for (const Measure& each : body.failureMeasures())
  {
    columns.push_back(measure(each));
  }
  columns.push_back({ "state_hash", [](const ArchivedIndividual& archived)
                      {
                        const Evaluation& evaluation = *archived.individual.evaluation;
                        return evaluation.valid ? hashToString(evaluation.state_hash) : "";
                      } });
  columns.push_back(
      { "phenotype_hash", [](const ArchivedIndividual& archived) { return toHex(archived.phenotype_hash); } });
  columns.push_back({ "genome_hash", [](const ArchivedIndividual& archived) { return toHex(archived.genome_hash); } });
  return columns;
}

/// A tree as a list of children, in the order of the descendants.
struct Forest
{
  explicit Forest(const std::vector<Descendant>& descendants) : children(descendants.size())
  {
    std::map<int64_t, size_t> place;
    for (size_t i = 0; i < descendants.size(); ++i)
    {
      const Individual& individual = descendants[i].archived.individual;
      const auto parent = place.find(individual.parent);
      (parent == place.end() ? roots : children[parent->second]).push_back(i);
      place[individual.id] = i;
    }
  }

  std::vector<std::vector<size_t>> children;
  std::vector<size_t> roots;
};

/// Without recursion: lineages are thousands of generations deep.
std::string newickTree(const std::vector<Descendant>& descendants, const Forest& forest, size_t root)
{
  struct Visit
  {
    size_t node;
    size_t next_child;
    int64_t parents_birth;
  };
  std::string text;
  std::vector<Visit> path = { { root, 0, 0 } };
  while (!path.empty())
  {
    Visit& visit = path.back();
    const Individual& individual = descendants[visit.node].archived.individual;
    const auto& children = forest.children[visit.node];
    if (visit.next_child < children.size())
    {
      text += visit.next_child == 0 ? "(" : ",";
      path.push_back({ children[visit.next_child++], 0, individual.generation });
      continue;
    }
    text += (children.empty() ? "" : ")") + individualName(individual.trial, individual.id) + ":" +
            toText(individual.generation - visit.parents_birth);
    path.pop_back();
  }
  return text + ";";
}
}  // namespace

std::vector<Descendant> readPhylogeny(const Archive& archive, int64_t trial)
{
  std::vector<ArchivedIndividual> individuals;
  const int64_t next_id = archive.extentOf(trial).next_id;
  for (int64_t first_id = 0; first_id < next_id; first_id += PAGE)
  {
    for (ArchivedIndividual& archived : archive.readIndividuals(trial, first_id, PAGE))
    {
      archived.individual.genome = Genome();  // nobody asks for it, and all of them would fill the memory
      archived.has_genome = false;
      individuals.push_back(std::move(archived));
    }
  }
  return withDeaths(archive, trial, std::move(individuals));
}

std::vector<Descendant> readAncestry(const Archive& archive, int64_t trial, int64_t id)
{
  return withDeaths(archive, trial, archive.readLineage(trial, id));
}

void writeNewick(const std::vector<Descendant>& descendants, const LineSink& sink)
{
  const Forest forest(descendants);
  for (const size_t root : forest.roots)
  {
    sink(newickTree(descendants, forest, root));
  }
}

void writeAlifeStandard(const std::vector<Descendant>& descendants, const Body& body, const LineSink& sink)
{
  const std::vector<Column> columns = traits(body);
  std::string header = "id,ancestor_list,origin_time,destruction_time,trait_trial";
  for (const Column& column : columns)
  {
    header += ",trait_" + column.name;
  }
  sink(header);
  for (const Descendant& descendant : descendants)
  {
    const Individual& individual = descendant.archived.individual;
    const std::string parent = parentOf(individual);
    std::string line = toText(individual.id) + ",[" + (parent.empty() ? "none" : parent) + "]," +
                       toText(individual.generation) + "," + (descendant.death ? toText(*descendant.death) : "inf") +
                       "," + toText(individual.trial);
    for (const Column& column : columns)
    {
      line += "," + column.value(descendant.archived);
    }
    sink(line);
  }
}

void writeCsv(const std::vector<Descendant>& descendants, const Body& body, const LineSink& sink)
{
  const std::vector<Column> columns = traits(body);
  std::string header = "trial,id,parent,generation,death";
  for (const Column& column : columns)
  {
    header += "," + column.name;
  }
  sink(header);
  for (const Descendant& descendant : descendants)
  {
    const Individual& individual = descendant.archived.individual;
    std::string line = toText(individual.trial) + "," + toText(individual.id) + "," + parentOf(individual) + "," +
                       toText(individual.generation) + "," + (descendant.death ? toText(*descendant.death) : "");
    for (const Column& column : columns)
    {
      line += "," + column.value(descendant.archived);
    }
    sink(line);
  }
}
}  // namespace devo_evo
