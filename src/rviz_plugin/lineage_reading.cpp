#include "rviz_plugin/lineage_reading.h"

#include "devo_evo/bodies/bodies.h"
#include "ros/parameters.h"

#include <ros/names.h>
#include <ros/param.h>

namespace devo_evo
{
namespace
{
/// Trial and id.
using Name = std::pair<int64_t, int64_t>;

Name championOf(const Archive& archive, std::optional<int64_t> trial)
{
  if (trial)
  {
    return { *trial, archive.championOf(*trial) };
  }
  const std::optional<ArchivedIndividual> best = bestChampion(archive);
  if (!best)
  {
    throw InvalidInput("no trial has a valid champion yet");
  }
  return { best->individual.trial, best->individual.id };
}

bool endsWith(const LineageView& view, const Name& name)
{
  return !view.individuals.empty() && Name(view.trial, view.individuals.back().individual.id) == name;
}
}  // namespace

LineageView readLineageView(const std::string& folder, std::optional<int64_t> trial, const LineageView& known)
{
  if (folder.empty() || folder.front() != '/')
  {
    throw InvalidInput("experiment is \"" + folder + "\"; it must be the absolute path of a folder");
  }
  const auto archive = openArchiveForReading(folder);
  const Name champion = championOf(*archive, trial);
  LineageView view;
  view.folder = folder;
  view.trial = champion.first;
  view.trials = archive->trials();
  if (known.folder == folder && endsWith(known, champion))
  {
    view.body = known.body;
    view.individuals = known.individuals;
    return view;
  }
  view.body = makeBody(archive->settings().body);
  view.individuals = archive->readLineage(champion.first, champion.second);
  for (ArchivedIndividual& individual : view.individuals)
  {
    individual.individual.genome = Genome();
  }
  return view;
}

std::string folderOf(const std::string& player)
{
  const std::string shown = readParameters(player).experiment.output;
  if (!shown.empty())
  {
    return shown;
  }
  const std::string name_space = ros::names::parentNamespace(player);
  const std::string evolver = ros::names::append(name_space, "evolver");
  if (!ros::param::has(evolver))
  {
    throw InvalidInput("no experiment runs in " + name_space + "; choose the folder of one");
  }
  const ExperimentSettings settings = readParameters(evolver).experiment;
  return settings.output.empty() ? defaultOutput(settings) : settings.output;
}
}  // namespace devo_evo
