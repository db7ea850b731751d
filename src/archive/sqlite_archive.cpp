#include "archive/sqlite_archive.h"

#include "archive/digest.h"
#include "archive/genome_table.h"
#include "archive/individual_table.h"
#include "archive/settings_table.h"

#include <algorithm>
#include <set>

namespace devo_evo
{
SqliteArchive::SqliteArchive(const std::string& output, Connection connection, std::unique_ptr<WriterLock> lock)
  : output_(output)
  , path_(archivePath(output))
  , lock_(std::move(lock))
  , connection_(std::move(connection))
  , settings_(guarded(path_, [this] { return readSettings(connection_); }))
  , lattice_(settings_.body)
{
}

SqliteArchive::~SqliteArchive()
{
  if (lock_)
  {
    // So that experiment.db alone is the whole experiment, even if a reader keeps the log in being.
    connection_.database().tryExec("PRAGMA wal_checkpoint(TRUNCATE)");
  }
}

void SqliteArchive::commitGeneration(const GenerationRecord& record)
{
  checkRecord(record);
  guarded(path_,
          [&]
          {
            SQLite::Transaction transaction(connection_.database(), SQLite::TransactionBehavior::IMMEDIATE);
            if (record.generation != lastGeneration(record.trial).value_or(-1) + 1)
            {
              throw std::logic_error("generation " + std::to_string(record.generation) + " of trial " +
                                     std::to_string(record.trial) + " does not follow the last one committed");
            }
            insertRecord(record);
            updateGenomes(record);
            transaction.commit();
          });
}

void SqliteArchive::checkRecord(const GenerationRecord& record) const
{
  if (!lock_)
  {
    throw std::logic_error("archive " + path_ + " was opened for reading");
  }
  int64_t last_id = -1;
  for (const Individual& newcomer : record.newcomers)
  {
    if (!newcomer.evaluation || newcomer.trial != record.trial || newcomer.generation != record.generation ||
        newcomer.id <= last_id)
    {
      throw std::logic_error("individual " + individualName(newcomer.trial, newcomer.id) +
                             " is no evaluated newcomer of the generation, or not in the order of ids");
    }
    last_id = newcomer.id;
  }
}

void SqliteArchive::insertRecord(const GenerationRecord& record)
{
  for (const Individual& newcomer : record.newcomers)
  {
    insertIndividual(connection_, newcomer, settings_.evolution.phaseLimit());
  }
  connection_
      .query(
          "INSERT INTO generations (trial, generation, champion, best_fitness, median_fitness) "
          "VALUES (?, ?, ?, ?, ?)",
          record.trial, record.generation, record.champion, record.best_fitness, record.median_fitness)
      .run();
  int64_t rank = 0;
  for (const int64_t id : record.survivors)
  {
    connection_
        .query("INSERT INTO survivors (trial, generation, rank, id) VALUES (?, ?, ?, ?)", record.trial,
               record.generation, ++rank, id)
        .run();
  }
}

void SqliteArchive::updateGenomes(const GenerationRecord& record)
{
  const std::set<int64_t> living(record.survivors.begin(), record.survivors.end());
  for (const Individual& newcomer : record.newcomers)
  {
    if (living.count(newcomer.id) != 0)
    {
      insertGenome(connection_, newcomer);
    }
  }
  std::vector<int64_t> dead;
  for (const int64_t id : survivorsOf(record.trial, record.generation - 1))
  {
    if (living.count(id) == 0)
    {
      dead.push_back(id);
    }
  }
  pruneGenomes(connection_, record.trial, dead, living);
}

std::optional<Evaluation> SqliteArchive::findEvaluation(const Hash128& phenotype_hash) const
{
  return guarded(path_, [&] { return findEvaluationOf(connection_, phenotype_hash); });
}

std::map<int64_t, TrialState> SqliteArchive::trialStates() const
{
  return guarded(path_,
                 [&]
                 {
                   const Snapshot snapshot(connection_);
                   std::map<int64_t, TrialState> states;
                   for (const int64_t trial : trials())
                   {
                     TrialState& state = states[trial];
                     state.generation = lastGeneration(trial).value();
                     state.next_id = nextId(connection_, trial);
                     for (const int64_t id : survivorsOf(trial, state.generation))
                     {
                       state.survivors.push_back(readSurvivor(trial, id, state.generation));
                     }
                   }
                   return states;
                 });
}

Individual SqliteArchive::readSurvivor(int64_t trial, int64_t id, int64_t generation) const
{
  const std::vector<ArchivedIndividual> self = descent(trial, id, false);
  if (self.empty() || !self.back().has_genome)
  {
    throw DamagedArchive("survivor " + individualName(trial, id) + " is missing or has lost its genome");
  }
  Individual individual = self.back().individual;
  individual.age += generation - individual.generation;
  return individual;
}

ArchivedIndividual SqliteArchive::readIndividual(int64_t trial, int64_t id) const
{
  return guarded(path_,
                 [&]
                 {
                   const Snapshot snapshot(connection_);
                   const std::vector<ArchivedIndividual> self = descent(trial, id, false);
                   if (self.empty())
                   {
                     throw InvalidInput("archive " + path_ + " has no individual " + individualName(trial, id));
                   }
                   return self.back();
                 });
}

std::vector<ArchivedIndividual> SqliteArchive::readLineage(int64_t trial, int64_t id) const
{
  return guarded(path_,
                 [&]
                 {
                   const Snapshot snapshot(connection_);
                   std::vector<ArchivedIndividual> lineage = descent(trial, id, true);
                   if (lineage.empty())
                   {
                     throw InvalidInput("archive " + path_ + " has no individual " + individualName(trial, id));
                   }
                   return lineage;
                 });
}

std::vector<ArchivedIndividual> SqliteArchive::descent(int64_t trial, int64_t id, bool all_ancestors) const
{
  return readDescent(connection_, settings_.evolution, lattice_, trial, id, all_ancestors);
}

int64_t SqliteArchive::championOf(int64_t trial) const
{
  return guarded(
      path_,
      [&]
      {
        Query query = connection_.query(
            "SELECT champion FROM generations WHERE trial = ? ORDER BY generation DESC LIMIT 1", trial);
        if (!query.next())
        {
          throw InvalidInput("archive " + path_ + " has no finished generation of trial " + std::to_string(trial));
        }
        return query.integer();
      });
}

std::vector<int64_t> SqliteArchive::trials() const
{
  return guarded(path_,
                 [&]
                 {
                   std::vector<int64_t> trials;
                   Query query = connection_.query("SELECT DISTINCT trial FROM generations ORDER BY trial");
                   while (query.next())
                   {
                     trials.push_back(query.integer());
                   }
                   return trials;
                 });
}

ExperimentSettings SqliteArchive::settings() const
{
  ExperimentSettings settings = guarded(path_, [&] { return readSettings(connection_); });
  settings.output = output_;
  return settings;
}

std::string SqliteArchive::digest() const
{
  return guarded(path_,
                 [&]
                 {
                   const Snapshot snapshot(connection_);
                   return computeDigest(connection_);
                 });
}

std::optional<int64_t> SqliteArchive::lastGeneration(int64_t trial) const
{
  Query query = connection_.query("SELECT max(generation) FROM generations WHERE trial = ?", trial);
  query.next();
  return query.optionalInteger();
}

std::vector<int64_t> SqliteArchive::survivorsOf(int64_t trial, int64_t generation) const
{
  std::vector<int64_t> survivors;
  Query query =
      connection_.query("SELECT id FROM survivors WHERE trial = ? AND generation = ? ORDER BY rank", trial, generation);
  while (query.next())
  {
    survivors.push_back(query.integer());
  }
  return survivors;
}
}  // namespace devo_evo
