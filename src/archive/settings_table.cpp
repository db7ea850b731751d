#include "archive/settings_table.h"

#include "archive/bytes.h"
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

/// Whether a parameter belongs to the experiment, not to the place or the machines it runs on.
bool isArchived(const ParameterSpec& spec)
{
  static const std::set<std::string> groups = { "experiment", "evolution", "body", "physics" };
  return groups.count(spec.group) != 0 && spec.name != "output";
}

Parameters parametersOf(const ExperimentSettings& settings)
{
  Parameters parameters;
  parameters.experiment = settings;
  return parameters;
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
  return parameters.experiment;
}

void writeParameter(Connection& connection, const ParameterSpec& spec, const Parameters& parameters)
{
  connection
      .query("INSERT OR REPLACE INTO parameters (name, value, unit) VALUES (?, ?, ?)", spec.name, spec.get(parameters),
             spec.unit)
      .run();
}

void writeSettings(Connection& connection, const ExperimentSettings& settings)
{
  const Parameters parameters = parametersOf(settings);
  for (const ParameterSpec& spec : parameterSpecs())
  {
    if (isArchived(spec))
    {
      writeParameter(connection, spec, parameters);
    }
  }
}

void checkResumable(Connection& connection, const ExperimentSettings& wanted)
{
  const Parameters ours = parametersOf(wanted);
  const Parameters archived = parametersOf(readSettings(connection));
  std::string differences;
  for (const ParameterSpec& spec : parameterSpecs())
  {
    if (isArchived(spec) && EXTENT.count(spec.name) == 0 && spec.get(ours) != spec.get(archived))
    {
      differences += (differences.empty() ? "" : ", ") + spec.name + " is " + spec.get(archived) + " there and " +
                     spec.get(ours) + " here";
    }
  }
  if (!differences.empty())
  {
    throw ArchiveError("output folder " + wanted.output + " holds another experiment: " + differences +
                       "; choose another output, or give the same values to resume it");
  }
}

void recordStart(Connection& connection, const Provenance& provenance)
{
  std::optional<Blob> fingerprint;
  if (provenance.engine_fingerprint != 0)
  {
    fingerprint = hashToBytes(provenance.engine_fingerprint);
    Query query = connection.query(
        "SELECT engine_fingerprint, version FROM starts "
        "WHERE engine_fingerprint IS NOT NULL AND engine_fingerprint <> ? LIMIT 1",
        fingerprint);
    if (query.next())
    {
      const std::string theirs = hashToString(hashFromBytes(query.blob(sizeof(uint64_t))));
      throw ArchiveError("the experiment was made by devo_evo " + query.text() + " with engine fingerprint " + theirs +
                         "; this is " + provenance.version + " with " + hashToString(provenance.engine_fingerprint) +
                         ", which would give other results: resume it with the version that made it");
    }
  }
  connection
      .query(
          "INSERT INTO starts (time_utc, version, compiler, processor, instruction_set, host, engine_fingerprint) "
          "VALUES (strftime('%Y-%m-%dT%H:%M:%SZ', 'now'), ?, ?, ?, ?, ?, ?)",
          provenance.version, provenance.compiler, provenance.processor, provenance.instruction_set, provenance.host,
          fingerprint)
      .run();
}
}  // namespace devo_evo
