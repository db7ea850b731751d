#include "devo_evo/archive/archive.h"

#include "archive/experiment_tables.h"
#include "archive/output_folder.h"
#include "archive/schema.h"
#include "archive/settings_table.h"
#include "archive/sqlite_archive.h"
#include "archive/start_table.h"

#include <algorithm>
#include <filesystem>

namespace devo_evo
{
namespace
{
/// The extent to note: what is asked for, but no less than what there is.
ExperimentSettings extendedByCommitted(Connection& connection, ExperimentSettings settings)
{
  Query query = connection.query("SELECT max(trial), max(generation) FROM generations");
  query.next();
  settings.trials = std::max(settings.trials, query.optionalNatural().value_or(0));
  settings.generations = std::max(settings.generations, query.optionalNatural().value_or(0));
  return settings;
}

/// Begins or resumes the experiment, in one transaction: a file never holds a part of this.
void begin(Connection& connection, const ExperimentSettings& settings, const Provenance& provenance)
{
  SQLite::Transaction transaction(connection.database(), SQLite::TransactionBehavior::IMMEDIATE);
  const std::shared_ptr<const Body> body = makeBody(settings.body);
  const bool is_new = createSchema(connection, experimentFile(), experimentTables(*body));
  addLaterTables(connection, *body);
  if (!is_new)
  {
    checkResumable(connection, settings, { settings.body.kind });
  }
  writeSettings(connection, extendedByCommitted(connection, settings), { settings.body.kind });
  recordStart(connection, provenance);
  transaction.commit();
}

std::string absolutePath(const std::string& output)
{
  return std::filesystem::absolute(output).string();
}
}  // namespace

std::optional<ArchivedIndividual> bestChampion(const Archive& archive)
{
  std::optional<ArchivedIndividual> best;
  for (const int64_t trial : archive.trials())
  {
    ArchivedIndividual champion = archive.readIndividual(trial, archive.championOf(trial));
    const auto& evaluation = champion.individual.evaluation;
    if (evaluation && evaluation->valid && (!best || evaluation->fitness > best->individual.evaluation->fitness))
    {
      best = std::move(champion);
    }
  }
  return best;
}

std::string archivePath(const std::string& output)
{
  return output + "/experiment.db";
}

std::unique_ptr<Archive> openArchiveForWriting(const ExperimentSettings& settings, const Provenance& provenance,
                                               int64_t maximum_size)
{
  const std::string output = absolutePath(settings.output);
  makeOutputFolder(output);
  auto lock = std::make_unique<WriterLock>(output);
  const std::string path = archivePath(output);
  const auto open = [&]
  {
    Connection connection = connectForWriting(path, maximum_size);
    begin(connection, settings, provenance);
    return std::make_unique<SqliteArchive>(output, std::move(connection), std::move(lock));
  };
  return guarded(path, open);
}

bool archiveHasBegun(const std::string& output)
{
  return hasBegun(archivePath(absolutePath(output)));
}

std::unique_ptr<Archive> openArchiveForReading(const std::string& output)
{
  const std::string folder = absolutePath(output);
  const std::string path = archivePath(folder);
  const auto open = [&]
  {
    Connection connection = connectForReading(path);
    checkSchema(connection, path);
    return std::make_unique<SqliteArchive>(folder, std::move(connection), nullptr);
  };
  return guarded(path, open);
}
}  // namespace devo_evo
