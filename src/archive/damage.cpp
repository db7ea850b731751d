#include "archive/damage.h"

#include "devo_evo/experiment/parameters.h"
#include "devo_evo/soft_body/text.h"

namespace devo_evo
{
namespace
{
// The tree of the living, from the last populations back to the random.
#define LIVING_AND_ANCESTORS                                                                               \
  "WITH RECURSIVE lineage (trial, id) AS ("                                                                \
  "SELECT s.trial, s.id FROM survivors AS s JOIN (SELECT trial, max(generation) AS last FROM generations " \
  "GROUP BY trial) AS g ON g.trial = s.trial AND g.last = s.generation "                                   \
  "UNION SELECT i.trial, i.parent FROM lineage JOIN individuals AS i ON i.trial = lineage.trial AND "      \
  "i.id = lineage.id WHERE i.parent IS NOT NULL) "

/// Rows that must not be.
struct Contradiction
{
  const char* sql;  ///< gives trial, generation (of birth, of individuals) and id of one; NULL: none, or not known
  const char* what;
};

const Contradiction CONTRADICTIONS[] = {
  { "SELECT NULL, NULL, NULL FROM starts WHERE number > 1 AND number - 1 NOT IN (SELECT number FROM starts) LIMIT 1",
    "rows are missing in the table starts, whose numbers do not count up" },
  { "SELECT trial, 0, NULL FROM individuals WHERE trial NOT IN (SELECT trial FROM generations) LIMIT 1",
    "the trial has individuals, but no row in the table generations" },
  { "SELECT trial, generation, id FROM individuals WHERE parent >= id ORDER BY trial, id LIMIT 1",
    "its parent was born after it" },
  { "SELECT s.trial, s.generation, NULL FROM survivors AS s LEFT JOIN generations AS g USING (trial, generation) "
    "WHERE g.trial IS NULL ORDER BY s.trial, s.generation LIMIT 1",
    "there are survivors, but this generation's row is missing in the table generations" },
  { "SELECT g.trial, NULL, g.id FROM genomes AS g LEFT JOIN individuals AS i USING (trial, id) WHERE i.id IS NULL "
    "ORDER BY g.trial, g.id LIMIT 1",
    "there is a genome, but this individual's row is missing in the table individuals" },
  { "SELECT trial, i.generation, id FROM genomes AS g JOIN individuals AS i USING (trial, id) WHERE g.parent IS NOT "
    "i.parent ORDER BY trial, id LIMIT 1",
    "its genome is noted with another parent" },
  { LIVING_AND_ANCESTORS
    "SELECT trial, i.generation, id FROM (SELECT trial, id FROM lineage EXCEPT SELECT trial, id "
    "FROM genomes) LEFT JOIN individuals AS i USING (trial, id) ORDER BY trial, id LIMIT 1",
    "it lives or has living descendants, but its row is missing in the table genomes" },
  { LIVING_AND_ANCESTORS
    "SELECT trial, i.generation, id FROM (SELECT trial, id FROM genomes EXCEPT SELECT trial, id "
    "FROM lineage) JOIN individuals AS i USING (trial, id) ORDER BY trial, id LIMIT 1",
    "it has no living descendant, but its genome is there" },
};

Offence ofTheWhole(const std::string& what)
{
  return { 0, 0, -1, what };
}

std::optional<Offence> damageToFile(Connection& connection)
{
  Query query = connection.query("PRAGMA integrity_check(1)");
  const std::string found = query.next() ? query.text() : "no answer";
  return found == "ok" ? std::nullopt : std::optional<Offence>(ofTheWhole("SQLite's integrity check: " + found));
}

std::optional<Offence> damageToParameters(Connection& connection)
{
  Query query = connection.query("SELECT name, unit FROM parameters ORDER BY name");
  while (query.next())
  {
    const std::string name = query.text();
    const std::string unit = query.text();
    if (unit != parameterSpec(name).unit)
    {
      return ofTheWhole("parameter " + name + " has the unit \"" + unit + "\" instead of \"" +
                        parameterSpec(name).unit + "\"");
    }
  }
  return std::nullopt;
}

std::optional<Offence> contradictingRow(Connection& connection)
{
  for (const Contradiction& contradiction : CONTRADICTIONS)
  {
    Query query = connection.query(contradiction.sql);
    if (query.next())
    {
      const int64_t trial = query.optionalNatural().value_or(0);
      const int64_t generation = query.optionalNatural().value_or(trial == 0 ? 0 : -1);
      return Offence{ trial, generation, query.optionalNatural().value_or(-1), contradiction.what };
    }
  }
  return std::nullopt;
}
}  // namespace

std::string Offence::place() const
{
  if (id >= 0)
  {
    return individualName(trial, id);
  }
  return trial > 0 ? "trial " + toText(trial) + ", generation " + toText(generation) : "archive";
}

std::optional<Offence> findDamageOf(Connection& connection)
{
  for (const auto& find : { damageToFile, damageToParameters, contradictingRow })
  {
    if (auto damage = find(connection))
    {
      return damage;
    }
  }
  return std::nullopt;
}
}  // namespace devo_evo
