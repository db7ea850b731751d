#include "archive/generation_table.h"

#include "archive/genome_table.h"
#include "archive/individual_table.h"

#include <set>

namespace devo_evo
{
namespace
{
/// The first column of all rows.
std::vector<int64_t> naturals(Query query)
{
  std::vector<int64_t> values;
  while (query.next())
  {
    values.push_back(query.natural());
  }
  return values;
}

/// The only column of the only row, if there is one.
std::optional<int64_t> optionalNatural(Query query)
{
  return query.next() ? query.optionalNatural() : std::nullopt;
}

void checkNewcomers(const GenerationRecord& record)
{
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

void checkFollows(Connection& connection, const GenerationRecord& record)
{
  const int64_t next = findLastGeneration(connection, record.trial).value_or(-1) + 1;
  if (record.generation != next)
  {
    throw std::logic_error("generation " + std::to_string(record.generation) + " of trial " +
                           std::to_string(record.trial) + " cannot be committed: the next is " + std::to_string(next));
  }
}

/// Keeps the genomes of newcomers who survive, drops those of which no living individual descends any more.
void updateGenomes(Connection& connection, const GenerationRecord& record, const GenomeLayout& layout)
{
  const std::set<int64_t> living(record.survivors.begin(), record.survivors.end());
  for (const Individual& newcomer : record.newcomers)
  {
    if (living.count(newcomer.id) != 0)
    {
      insertGenome(connection, newcomer, layout);
    }
  }
  std::vector<int64_t> dead;
  for (const int64_t id : findSurvivors(connection, record.trial, record.generation - 1))
  {
    if (living.count(id) == 0)
    {
      dead.push_back(id);
    }
  }
  pruneGenomes(connection, record.trial, dead, living);
}
}  // namespace

void insertGeneration(Connection& connection, const GenerationRecord& record, const ArchivedBody& body)
{
  checkNewcomers(record);
  checkFollows(connection, record);
  for (const Individual& newcomer : record.newcomers)
  {
    insertIndividual(connection, newcomer, body);
  }
  connection
      .query(
          "INSERT INTO generations (trial, generation, champion, best_fitness, median_fitness) "
          "VALUES (?, ?, ?, ?, ?)",
          record.trial, record.generation, record.champion, record.best_fitness, record.median_fitness)
      .run();
  int64_t rank = 0;
  for (const int64_t id : record.survivors)
  {
    connection
        .query("INSERT INTO survivors (trial, generation, rank, id) VALUES (?, ?, ?, ?)", record.trial,
               record.generation, ++rank, id)
        .run();
  }
  updateGenomes(connection, record, body.layout);
}

std::vector<int64_t> findTrials(Connection& connection)
{
  return naturals(connection.query("SELECT DISTINCT trial FROM generations ORDER BY trial"));
}

std::optional<int64_t> findLastGeneration(Connection& connection, int64_t trial)
{
  return optionalNatural(connection.query("SELECT max(generation) FROM generations WHERE trial = ?", trial));
}

std::optional<int64_t> findLastChampion(Connection& connection, int64_t trial)
{
  return optionalNatural(
      connection.query("SELECT champion FROM generations WHERE trial = ? ORDER BY generation DESC LIMIT 1", trial));
}

std::optional<TrialExtent> findExtent(Connection& connection, int64_t trial)
{
  const auto last = findLastGeneration(connection, trial);
  if (!last)
  {
    return std::nullopt;
  }
  TrialExtent extent;
  extent.last_generation = *last;
  extent.individuals =
      optionalNatural(connection.query("SELECT count(*) FROM individuals WHERE trial = ?", trial)).value_or(0);
  extent.survivors =
      optionalNatural(connection.query("SELECT count(*) FROM survivors WHERE trial = ?", trial)).value_or(0);
  extent.next_id = findNextId(connection, trial);
  return extent;
}

std::optional<ArchivedSelection> findSelection(Connection& connection, int64_t trial, int64_t generation)
{
  Query query = connection.query(
      "SELECT champion, best_fitness, median_fitness FROM generations WHERE trial = ? AND generation = ?", trial,
      generation);
  if (!query.next())
  {
    return std::nullopt;
  }
  ArchivedSelection selection;
  selection.champion = query.natural();
  selection.best_fitness = query.real();
  selection.median_fitness = query.real();
  selection.survivors = findSurvivors(connection, trial, generation);
  return selection;
}

std::vector<int64_t> findSurvivors(Connection& connection, int64_t trial, int64_t generation)
{
  return naturals(
      connection.query("SELECT id FROM survivors WHERE trial = ? AND generation = ? ORDER BY rank", trial, generation));
}
}  // namespace devo_evo
