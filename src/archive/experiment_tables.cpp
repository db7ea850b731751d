#include "archive/experiment_tables.h"

#include "archive/schema.h"

namespace devo_evo
{
namespace
{
// Comments stay in the file: `.schema` shows them. Not STRICT, so that SQLite from before 3.37 reads it too. What
// stands between @ is the body's.
const char* const TABLES = R"(
CREATE TABLE individuals (  -- everybody who ever lived
  trial             INTEGER NOT NULL,
  id                INTEGER NOT NULL,  -- counts up from 0 within the trial, in order of birth
  parent            INTEGER,           -- id; NULL: random
  generation        INTEGER NOT NULL,  -- of birth
  age               INTEGER NOT NULL,  -- at birth: generations since the oldest ancestor was random
  valid             INTEGER NOT NULL CHECK (valid IN (0, 1)),  -- 0: the simulation diverged, and has no results
  fitness           REAL CHECK ((fitness IS NOT NULL) = valid),  -- [@fitness_unit@]
@measures@  morphology_window REAL NOT NULL,  -- W_L [1, 0 to 1]
  control_window    REAL NOT NULL,  -- W_Phi [1, 0 to 1]
@failures@  state_hash BLOB CHECK (state_hash IS NULL OR length(state_hash) = 8),  -- of the final state; NULL if invalid
  phenotype_hash    BLOB NOT NULL CHECK (length(phenotype_hash) = 16),  -- of the developmental program
  genome_hash       BLOB NOT NULL CHECK (length(genome_hash) = 16),     -- of program and mutation rates
  PRIMARY KEY (trial, id)
) WITHOUT ROWID;
CREATE INDEX individuals_by_phenotype ON individuals (phenotype_hash);

CREATE TABLE genomes (  -- of the living and their ancestors; arrays of little-endian doubles
  number             INTEGER PRIMARY KEY,  -- of no meaning
  trial              INTEGER NOT NULL,
  id                 INTEGER NOT NULL,
  parent             INTEGER,        -- id; NULL: random
@arrays@);
CREATE UNIQUE INDEX genomes_by_id ON genomes (trial, id);
CREATE INDEX genomes_by_parent ON genomes (trial, parent);

CREATE TABLE generations (  -- that are finished
  trial          INTEGER NOT NULL,
  generation     INTEGER NOT NULL,  -- from 0
  champion       INTEGER NOT NULL,  -- id of the best valid survivor; of the first survivor if none is valid
  best_fitness   REAL,  -- the champion's [@fitness_unit@]; NULL: no survivor is valid
  median_fitness REAL,  -- of the valid survivors [@fitness_unit@]; NULL: there is none
  PRIMARY KEY (trial, generation)
) WITHOUT ROWID;

CREATE TABLE survivors (  -- the population after selection
  trial      INTEGER NOT NULL,
  generation INTEGER NOT NULL,
  rank       INTEGER NOT NULL,  -- from 1, the champion's
  id         INTEGER NOT NULL,
  PRIMARY KEY (trial, generation, rank)
) WITHOUT ROWID;

CREATE VIEW champions AS  -- the best robot of each generation, with its age in that generation
  SELECT g.trial, g.generation, g.champion AS id, i.age + g.generation - i.generation AS age, i.fitness,
         g.median_fitness, i.morphology_window, i.control_window
  FROM generations AS g JOIN individuals AS i ON i.trial = g.trial AND i.id = g.champion;
)";

// Tables that archives from before have not: made when one is opened for writing, taken as empty when one is read.
const char* const LATER_TABLES = R"(
CREATE TABLE IF NOT EXISTS stops (  -- when an evolver closed this archive; none for one that was killed
  start       INTEGER PRIMARY KEY,  -- starts.number
  time_utc    TEXT NOT NULL,        -- 2018-04-17T12:34:56Z
  generations INTEGER NOT NULL      -- finished in all trials by then
);

CREATE TABLE IF NOT EXISTS evaluators (  -- simulators' machines, by start; none if the evolver simulated by itself
  start           INTEGER NOT NULL,  -- starts.number
  host            TEXT NOT NULL,
  processor       TEXT NOT NULL,     -- '' if not known
  instruction_set TEXT NOT NULL,
  version         TEXT NOT NULL,     -- of devo_evo
  evaluations     INTEGER NOT NULL,  -- of robots, that were used
  PRIMARY KEY (start, host, processor, instruction_set, version)
) WITHOUT ROWID;

CREATE TABLE IF NOT EXISTS founders (  -- genomes that every trial started with; arrays as in genomes
  id                 INTEGER PRIMARY KEY,  -- in each trial; founders beyond are random
@arrays@);
)";

std::string replaced(std::string text, const std::string& mark, const std::string& by)
{
  for (size_t found = text.find(mark); found != std::string::npos; found = text.find(mark, found + by.size()))
  {
    text.replace(found, mark.size(), by);
  }
  return text;
}

std::string columns(const std::vector<Measure>& measures)
{
  std::string text;
  for (const Measure& measure : measures)
  {
    text += "  " + measure.name + (measure.whole ? " INTEGER,  -- " : " REAL,  -- ") + measure.meaning + " [" +
            measure.unit + "]" + (measure.may_lack ? "; NULL: never\n" : "\n");
  }
  return text;
}

std::string arrayColumns(const GenomePart& part, const GenomeLayout& layout)
{
  const std::string meaning = "[" + part.unit + "], one per " + part.place;
  const std::string order = layout.grid.empty() ? "" : ", x + grid_x * (y + grid_y * z)";
  return "  " + part.initialName() + " BLOB NOT NULL,  -- " + meaning + order + "\n  " + part.finalName() +
         " BLOB,  -- NULL: as " + part.initialName() + "\n";
}

std::string withColumns(std::string tables, const Body& body)
{
  const GenomeLayout layout = body.layout(EvolutionSettings());
  tables = replaced(std::move(tables), "@fitness_unit@", body.fitnessUnit());
  tables = replaced(std::move(tables), "@measures@", columns(body.measures()));
  tables = replaced(std::move(tables), "@failures@", columns(body.failureMeasures()));
  return replaced(std::move(tables), "@arrays@",
                  arrayColumns(layout.morphology, layout) + arrayColumns(layout.control, layout) +
                      "  mutation_rate BLOB  -- [1]; NULL: not part of the genome\n");
}
}  // namespace

std::string experimentTables(const Body& body)
{
  return withColumns(TABLES, body);
}

void addLaterTables(Connection& connection, const Body& body)
{
  connection.database().exec(withColumns(LATER_TABLES, body));
  if (!hasColumn(connection, "starts", "ros"))
  {
    connection.database().exec("ALTER TABLE starts ADD COLUMN ros TEXT NOT NULL DEFAULT ''");
  }
}
}  // namespace devo_evo
