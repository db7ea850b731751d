#include "archive/damage.h"

#include "devo_evo/experiment/parameters.h"

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
  const char* sql;  ///< gives trial and id, or trial and generation, of one
  const char* message;
};

const Contradiction CONTRADICTIONS[] = {
  { "SELECT trial, id FROM individuals WHERE trial NOT IN (SELECT trial FROM generations) LIMIT 1",
    ": this individual belongs to a trial that has no finished generation" },
  { "SELECT s.trial, s.generation FROM survivors AS s LEFT JOIN generations AS g USING (trial, generation) "
    "WHERE g.trial IS NULL LIMIT 1",
    " (trial/generation): there are survivors of a generation that is not there" },
  { "SELECT g.trial, g.id FROM genomes AS g LEFT JOIN individuals AS i USING (trial, id) WHERE i.id IS NULL LIMIT 1",
    ": there is a genome, but no such individual" },
  { "SELECT trial, id FROM genomes AS g JOIN individuals AS i USING (trial, id) WHERE g.parent IS NOT i.parent LIMIT 1",
    ": its genome is noted with another parent" },
  { LIVING_AND_ANCESTORS "SELECT trial, id FROM lineage EXCEPT SELECT trial, id FROM genomes LIMIT 1",
    ": it lives or has living descendants, but its genome is not there" },
  { LIVING_AND_ANCESTORS "SELECT trial, id FROM genomes EXCEPT SELECT trial, id FROM lineage LIMIT 1",
    ": it has no living descendant, but its genome is there" },
};

std::string damageToFile(Connection& connection)
{
  Query query = connection.query("PRAGMA integrity_check(1)");
  const std::string found = query.next() ? query.text() : "no answer";
  return found == "ok" ? "" : "SQLite's integrity check: " + found;
}

std::string damageToParameters(Connection& connection)
{
  Query query = connection.query("SELECT name, unit FROM parameters ORDER BY name");
  while (query.next())
  {
    const std::string name = query.text();
    const std::string unit = query.text();
    if (unit != parameterSpec(name).unit)
    {
      return "parameter " + name + " has the unit \"" + unit + "\" instead of \"" + parameterSpec(name).unit + "\"";
    }
  }
  return "";
}
}  // namespace

std::string findDamageOf(Connection& connection)
{
  std::string damage = damageToFile(connection);
  if (damage.empty())
  {
    damage = damageToParameters(connection);
  }
  for (const Contradiction& contradiction : CONTRADICTIONS)
  {
    if (!damage.empty())
    {
      break;
    }
    Query query = connection.query(contradiction.sql);
    if (query.next())
    {
      const int64_t trial = query.natural();
      damage = individualName(trial, query.natural()) + contradiction.message;
    }
  }
  return damage;
}
}  // namespace devo_evo
