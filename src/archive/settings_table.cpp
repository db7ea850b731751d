#include "archive/settings_table.h"

#include "archive/archived_body.h"
#include "archive/founder_table.h"
#include "devo_evo/experiment/parameters.h"
#include "devo_evo/soft_body/text.h"

#include <algorithm>
#include <set>

namespace devo_evo
{
namespace
{
/// How far the experiment goes; these may change when it is resumed.
const std::set<std::string> EXTENT = { "trials", "generations" };

Parameters parametersOf(const ExperimentSettings& settings)
{
  Parameters parameters;
  parameters.experiment = settings;
  return parameters;
}

bool describes(const ParameterSpec& spec, const std::vector<BodyKind>& kinds)
{
  return std::any_of(kinds.begin(), kinds.end(), [&](BodyKind kind) { return describesExperiment(spec, kind); });
}

/// Empty if there is none.
std::string differenceOfFounders(const EvolutionSettings& there, const EvolutionSettings& here)
{
  const auto count = [](const EvolutionSettings& settings)
  { return settings.founders ? settings.founders->size() : 0; };
  const auto describe = [](size_t founders)
  { return founders == 0 ? "random" : toText(static_cast<int64_t>(founders)) + " given robots"; };
  if (count(there) != count(here))
  {
    return "founders are " + describe(count(there)) + " there and " + describe(count(here)) + " here";
  }
  return count(there) == 0 || *there.founders == *here.founders ? "" : "founders are other robots there than here";
}
}  // namespace

ExperimentSettings readSettings(Connection& connection)
{
  Parameters parameters;
  Query query = connection.query("SELECT name, value FROM parameters ORDER BY name");
  try
  {
    while (query.next())
    {
      const std::string name = query.text();
      // One that is missing did not exist when the archive was made: it had its default value.
      setParameter(parameters, name, query.text(), "table parameters");
    }
    parameters.experiment.body.validate();
    parameters.experiment.evolution.validate();
  }
  catch (const InvalidInput& error)
  {
    throw DamagedArchive(error.what());
  }
  parameters.experiment.output.clear();
  parameters.experiment.evolution.founders = readFounders(connection, ArchivedBody(parameters.experiment).layout);
  return parameters.experiment;
}

void writeParameter(Connection& connection, const ParameterSpec& spec, const Parameters& parameters)
{
  connection
      .query("INSERT OR REPLACE INTO parameters (name, value, unit) VALUES (?, ?, ?)", spec.name, spec.get(parameters),
             spec.unit)
      .run();
}

void writeSettings(Connection& connection, const ExperimentSettings& settings, const std::vector<BodyKind>& kinds)
{
  const Parameters parameters = parametersOf(settings);
  for (const ParameterSpec& spec : parameterSpecs())
  {
    if (describes(spec, kinds))
    {
      writeParameter(connection, spec, parameters);
    }
  }
  writeFounders(connection, settings.evolution, ArchivedBody(settings).layout);
}

void checkResumable(Connection& connection, const ExperimentSettings& wanted, const std::vector<BodyKind>& kinds)
{
  const Parameters ours = parametersOf(wanted);
  const Parameters archived = parametersOf(readSettings(connection));
  std::string differences;
  for (const ParameterSpec& spec : parameterSpecs())
  {
    if (describes(spec, kinds) && EXTENT.count(spec.name) == 0 && spec.get(ours) != spec.get(archived))
    {
      differences += (differences.empty() ? "" : ", ") + spec.name + " is " + spec.get(archived) + " there and " +
                     spec.get(ours) + " here";
    }
  }
  const std::string founders = differenceOfFounders(archived.experiment.evolution, ours.experiment.evolution);
  if (!founders.empty())
  {
    differences += (differences.empty() ? "" : ", ") + founders;
  }
  if (!differences.empty())
  {
    throw ArchiveError("output folder " + wanted.output + " holds another experiment: " + differences +
                       "; choose another output, or give the same values to resume it");
  }
}
}  // namespace devo_evo
