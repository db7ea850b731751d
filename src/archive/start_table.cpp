#include "archive/start_table.h"

#include "archive/bytes.h"
#include "archive/schema.h"
#include "devo_evo/soft_body/text.h"

namespace devo_evo
{
namespace
{
void readEvaluators(Connection& connection, std::vector<Start>& starts)
{
  if (!hasTable(connection, "evaluators"))
  {
    return;
  }
  for (Start& start : starts)
  {
    Query query = connection.query(
        "SELECT host, processor, instruction_set, version, evaluations FROM evaluators WHERE start = ?", start.number);
    while (query.next())
    {
      Evaluator evaluator;
      evaluator.host = query.text();
      evaluator.processor = query.text();
      evaluator.instruction_set = query.text();
      evaluator.version = query.text();
      evaluator.evaluations = query.natural();
      start.evaluators.push_back(evaluator);
    }
  }
}
}  // namespace

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
          "INSERT INTO starts (time_utc, version, compiler, processor, instruction_set, host, ros, engine_fingerprint) "
          "VALUES (strftime('%Y-%m-%dT%H:%M:%SZ', 'now'), ?, ?, ?, ?, ?, ?, ?)",
          provenance.version, provenance.compiler, provenance.processor, provenance.instruction_set, provenance.host,
          provenance.ros, fingerprint)
      .run();
}

void recordStop(Connection& connection)
{
  connection
      .query(
          "INSERT OR REPLACE INTO stops (start, time_utc, generations) "
          "VALUES ((SELECT max(number) FROM starts), strftime('%Y-%m-%dT%H:%M:%SZ', 'now'), "
          "(SELECT count(*) FROM generations))")
      .run();
}

void recordEvaluators(Connection& connection, const std::vector<Evaluator>& evaluators)
{
  for (const Evaluator& evaluator : evaluators)
  {
    connection
        .query(
            "INSERT OR REPLACE INTO evaluators (start, host, processor, instruction_set, version, evaluations) "
            "VALUES ((SELECT max(number) FROM starts), ?, ?, ?, ?, ?)",
            evaluator.host, evaluator.processor, evaluator.instruction_set, evaluator.version, evaluator.evaluations)
        .run();
  }
}

std::vector<Start> readStarts(Connection& connection)
{
  const std::string ros = hasColumn(connection, "starts", "ros") ? "ros" : "''";
  const bool with_stops = hasTable(connection, "stops");
  const std::string sql = "SELECT number, s.time_utc, version, compiler, processor, instruction_set, host, " + ros +
                          ", engine_fingerprint, " +
                          (with_stops ? "t.time_utc, t.generations FROM starts AS s LEFT JOIN stops AS t ON t.start = "
                                        "s.number ORDER BY number"
                                      : "NULL, NULL FROM starts AS s ORDER BY number");
  std::vector<Start> starts;
  Query query = connection.query(sql);
  while (query.next())
  {
    Start start;
    start.number = query.natural();
    start.time_utc = query.text();
    start.provenance.version = query.text();
    start.provenance.compiler = query.text();
    start.provenance.processor = query.text();
    start.provenance.instruction_set = query.text();
    start.provenance.host = query.text();
    start.provenance.ros = query.text();
    const auto fingerprint = query.optionalBlob(sizeof(uint64_t));
    start.provenance.engine_fingerprint = fingerprint ? hashFromBytes(*fingerprint) : 0;
    start.stop_utc = query.optionalText();
    start.generations_at_stop = query.optionalNatural().value_or(0);
    starts.push_back(start);
  }
  readEvaluators(connection, starts);
  return starts;
}
}  // namespace devo_evo
