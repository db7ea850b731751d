#include "archive/sqlite_archive.h"

#include "archive/damage.h"
#include "archive/digest.h"
#include "archive/generation_table.h"
#include "archive/genome_table.h"
#include "archive/individual_table.h"
#include "archive/schema.h"
#include "archive/settings_table.h"
#include "archive/start_table.h"

namespace devo_evo
{
SqliteArchive::SqliteArchive(const std::string& output, Connection connection, std::unique_ptr<WriterLock> lock)
  : output_(output)
  , path_(archivePath(output))
  , file_(fileIdentity(path_))
  , lock_(std::move(lock))
  , connection_(std::move(connection))
  , settings_(settings())
  , body_(settings_)
{
}

SqliteArchive::~SqliteArchive()
{
  if (lock_)
  {
    noteStop();
    leaveOneFile(connection_);
  }
}

void SqliteArchive::commitGenerations(const std::vector<GenerationRecord>& records)
{
  checkWritable();
  working([&] { write(records); });
}

std::optional<Evaluation> SqliteArchive::findEvaluation(const Hash128& phenotype_hash) const
{
  return working([&] { return findEvaluationOf(connection_, *body_.body, phenotype_hash); });
}

std::map<int64_t, TrialState> SqliteArchive::trialStates() const
{
  const auto states_of_all = [&]
  {
    std::map<int64_t, TrialState> states;
    for (const int64_t trial : findTrials(connection_))
    {
      states[trial] = stateOf(trial);
    }
    return states;
  };
  return reading(states_of_all);
}

ArchivedIndividual SqliteArchive::readIndividual(int64_t trial, int64_t id) const
{
  return reading([&] { return descent(trial, id, false).back(); });
}

std::vector<ArchivedIndividual> SqliteArchive::readLineage(int64_t trial, int64_t id) const
{
  return reading([&] { return descent(trial, id, true); });
}

int64_t SqliteArchive::championOf(int64_t trial) const
{
  const auto champion = working([&] { return findLastChampion(connection_, trial); });
  if (!champion)
  {
    throw InvalidInput("archive " + path_ + " has no finished generation of trial " + std::to_string(trial));
  }
  return *champion;
}

std::vector<int64_t> SqliteArchive::trials() const
{
  return working([&] { return findTrials(connection_); });
}

TrialExtent SqliteArchive::extentOf(int64_t trial) const
{
  const auto extent = reading([&] { return findExtent(connection_, trial); });
  if (!extent)
  {
    throw InvalidInput("archive " + path_ + " has no finished generation of trial " + std::to_string(trial));
  }
  return *extent;
}

std::vector<ArchivedIndividual> SqliteArchive::readIndividuals(int64_t trial, int64_t first_id, int64_t count) const
{
  const auto individuals_with_genomes = [&]
  {
    auto individuals = findIndividuals(connection_, *body_.body, trial, first_id, count);
    for (ArchivedIndividual& archived : individuals)
    {
      auto genome = findGenome(connection_, trial, archived.individual.id, body_.layout);
      archived.has_genome = genome.has_value();
      archived.individual.genome = std::move(genome).value_or(Genome());
    }
    return individuals;
  };
  return reading(individuals_with_genomes);
}

std::optional<ArchivedSelection> SqliteArchive::readSelection(int64_t trial, int64_t generation) const
{
  return reading([&] { return findSelection(connection_, trial, generation); });
}

std::vector<Start> SqliteArchive::starts() const
{
  return reading([&] { return readStarts(connection_); });
}

std::optional<Offence> SqliteArchive::findDamage() const
{
  return reading([&] { return findDamageOf(connection_); });
}

ExperimentSettings SqliteArchive::settings() const
{
  ExperimentSettings settings = working([&] { return readSettings(connection_); });
  settings.output = output_;
  return settings;
}

std::string SqliteArchive::digest() const
{
  return reading([&] { return computeDigest(connection_); });
}

void SqliteArchive::checkWritable() const
{
  if (!lock_)
  {
    throw std::logic_error("archive " + path_ + " was opened for reading");
  }
  if (fileIdentity(path_) != file_)
  {
    // SQLite would go on writing to a file that nobody can find any more.
    throw ArchiveError("archive " + path_ + " was moved, deleted or replaced while it was written to; put it back " +
                       "where it was and start again");
  }
}

/// Only for people who ask later: what cannot be noted (on a full disk, say) is not worth an error.
void SqliteArchive::noteStop() noexcept
{
  try
  {
    connection_.beginWork();
    recordEvaluators(connection_, evaluators_);
    recordStop(connection_);
  }
  catch (const std::exception&)
  {
  }
}

void SqliteArchive::write(const std::vector<GenerationRecord>& records)
{
  SQLite::Transaction transaction(connection_.database(), SQLite::TransactionBehavior::IMMEDIATE);
  for (const GenerationRecord& record : records)
  {
    insertGeneration(connection_, record, body_);
  }
  recordEvaluators(connection_, evaluators_);
  transaction.commit();
}

TrialState SqliteArchive::stateOf(int64_t trial) const
{
  TrialState state;
  state.generation = findLastGeneration(connection_, trial).value();
  state.next_id = findNextId(connection_, trial);
  for (const int64_t id : findSurvivors(connection_, trial, state.generation))
  {
    state.survivors.push_back(survivor(trial, id, state.generation));
  }
  if (state.survivors.empty())
  {
    throw DamagedArchive("nobody survived generation " + std::to_string(state.generation) + " of trial " +
                         std::to_string(trial));
  }
  return state;
}

Individual SqliteArchive::survivor(int64_t trial, int64_t id, int64_t generation) const
{
  const auto ancestors = readDescent(connection_, settings_, body_, trial, id, false);
  if (ancestors.empty() || !ancestors.back().has_genome || ancestors.back().individual.generation > generation)
  {
    throw DamagedArchive("survivor " + individualName(trial, id) + " of generation " + std::to_string(generation) +
                         " is missing, has lost its genome, or was born later");
  }
  Individual individual = ancestors.back().individual;
  individual.age += generation - individual.generation;
  return individual;
}

std::vector<ArchivedIndividual> SqliteArchive::descent(int64_t trial, int64_t id, bool all_ancestors) const
{
  auto individuals = readDescent(connection_, settings_, body_, trial, id, all_ancestors);
  if (individuals.empty())
  {
    throw InvalidInput("archive " + path_ + " has no individual " + individualName(trial, id));
  }
  return individuals;
}
}  // namespace devo_evo
