#include "study/study_tables.h"

namespace devo_evo
{
namespace
{
// Of views: the columns of an evaluation, and where it is found if the robot lived in the world it evolved in.
#define RESULTS                                                                                  \
  "e.start, e.valid, e.fitness, e.displacement_y_voxels, e.displacement_xy_voxels, "             \
  "e.first_top_contact_since_birth_s, e.fell_over_since_birth_s, e.turns, e.airborne_fraction, " \
  "e.divergence_step, e.divergence_bond, e.divergence_strain, e.state_hash, e.velocities"
#define AS_EVOLVED "JOIN worlds AS w ON w.name = 'as_evolved' JOIN evaluations AS e USING (world, phenotype_hash)"

// Comments stay in the file: `.schema` shows them.
const char* const TABLES = R"(
CREATE TABLE arms (  -- the experiments of the study
  arm           TEXT NOT NULL PRIMARY KEY,  -- also its folder within the study's
  part          TEXT NOT NULL,  -- main, partial, baselines, sweep or rigid
  treatment     TEXT NOT NULL,
  profile       TEXT NOT NULL,
  mutation_rate TEXT NOT NULL,
  selection     TEXT NOT NULL,
  trials        INTEGER NOT NULL,  -- asked for
  generations   INTEGER NOT NULL   -- asked for
) WITHOUT ROWID;

CREATE TABLE champions (  -- whom analyses were last made of
  arm        TEXT NOT NULL,
  trial      INTEGER NOT NULL,
  id         INTEGER NOT NULL,
  generation INTEGER NOT NULL,  -- the trial's last one then
  fitness    REAL,              -- [body lengths]; NULL: invalid
  PRIMARY KEY (arm, trial)
) WITHOUT ROWID;

CREATE TABLE worlds (  -- what else than the genome a simulation depended on
  world    INTEGER PRIMARY KEY,
  name     TEXT NOT NULL UNIQUE,
  quantity TEXT NOT NULL,  -- none, friction, gravity, slope or actuation_amplitude
  value    REAL,           -- factor; of a slope, rise over run along +y; NULL: as evolved
  settings TEXT NOT NULL   -- all parameters of body and physics, a JSON object
);

CREATE TABLE evaluations (  -- each robot in each world
  world          INTEGER NOT NULL,
  phenotype_hash BLOB NOT NULL CHECK (length(phenotype_hash) = 16),
  start          INTEGER NOT NULL,  -- of starts: when and by what it was simulated
  valid          INTEGER NOT NULL CHECK (valid IN (0, 1)),
  fitness                         REAL CHECK ((fitness IS NOT NULL) = valid),  -- [body lengths]
  displacement_y_voxels           REAL,  -- [voxels]
  displacement_xy_voxels          REAL,  -- [voxels]
  first_top_contact_since_birth_s REAL,  -- [s]; NULL: never
  fell_over_since_birth_s         REAL,  -- [s]; NULL: never
  turns                           REAL,  -- [full turns]
  airborne_fraction               REAL,  -- [1]
  state_hash        BLOB CHECK (state_hash IS NULL OR length(state_hash) = 8),
  divergence_step   INTEGER,
  divergence_bond   INTEGER,
  divergence_strain REAL,
  velocities        BLOB,  -- little-endian doubles, in windows of 0.5 s [body lengths/s]; NULL: not kept, or invalid
  PRIMARY KEY (world, phenotype_hash)
) WITHOUT ROWID;

CREATE TABLE variants (  -- champions with frozen development
  arm TEXT NOT NULL, trial INTEGER NOT NULL, id INTEGER NOT NULL,
  moment            TEXT NOT NULL,  -- birth, midlife or death
  scope             TEXT NOT NULL,  -- both, body or control
  morphology_window REAL NOT NULL,
  control_window    REAL NOT NULL,
  phenotype_hash    BLOB NOT NULL,
  PRIMARY KEY (arm, trial, id, moment, scope)
) WITHOUT ROWID;

CREATE TABLE walk_steps (  -- random walks from champions
  arm TEXT NOT NULL, trial INTEGER NOT NULL, id INTEGER NOT NULL,
  space          TEXT NOT NULL,     -- control or body
  robot          TEXT NOT NULL,     -- champion or removed
  operator       TEXT NOT NULL,     -- redrawn_rates or one_voxel
  walk           INTEGER NOT NULL,  -- from 1
  step           INTEGER NOT NULL,  -- from 0, the start
  voxels_changed INTEGER NOT NULL,  -- since the last step
  phenotype_hash BLOB NOT NULL,
  PRIMARY KEY (arm, trial, id, space, robot, operator, walk, step)
) WITHOUT ROWID;

CREATE TABLE ancestors (  -- lineages of champions
  arm TEXT NOT NULL, trial INTEGER NOT NULL, champion INTEGER NOT NULL,
  position          INTEGER NOT NULL,  -- 0: the founder
  id                INTEGER NOT NULL,
  generation        INTEGER NOT NULL,  -- of birth
  morphology_window REAL NOT NULL,
  control_window    REAL NOT NULL,
  body_initial_towards_final    REAL,  -- by how much that end closed W_L since the parent; NULL: the founder
  body_final_towards_initial    REAL,
  control_initial_towards_final REAL,  -- the same of W_Phi
  control_final_towards_initial REAL,
  phenotype_hash    BLOB NOT NULL,
  PRIMARY KEY (arm, trial, champion, position)
) WITHOUT ROWID;

CREATE TABLE neutral_lineages (  -- from the founder of a champion's lineage, without selection
  arm TEXT NOT NULL, trial INTEGER NOT NULL, champion INTEGER NOT NULL,
  replicate          INTEGER NOT NULL,  -- from 1
  morphology_windows BLOB NOT NULL,     -- little-endian doubles, by position
  control_windows    BLOB NOT NULL,
  PRIMARY KEY (arm, trial, champion, replicate)
) WITHOUT ROWID;

CREATE TABLE traces (  -- whose velocity over life is wanted
  arm TEXT NOT NULL, trial INTEGER NOT NULL, id INTEGER NOT NULL,
  robot          TEXT NOT NULL,  -- champion or frozen_at_birth
  phenotype_hash BLOB NOT NULL,
  PRIMARY KEY (arm, trial, id, robot)
) WITHOUT ROWID;

CREATE TABLE robustness (  -- champions in other worlds
  arm TEXT NOT NULL, trial INTEGER NOT NULL, id INTEGER NOT NULL,
  world          INTEGER NOT NULL,
  phenotype_hash BLOB NOT NULL,
  PRIMARY KEY (arm, trial, id, world)
) WITHOUT ROWID;

CREATE TABLE mutational_impact (  -- what reproductions of a random parent change
  treatment           TEXT NOT NULL,
  profile             TEXT NOT NULL,
  traits              INTEGER NOT NULL,  -- that the treatment evolves
  mutation_rate       REAL NOT NULL,
  reproductions       INTEGER NOT NULL,
  voxels_changed_mean REAL NOT NULL,     -- in at least one trait
  voxels_changed_sd   REAL NOT NULL,     -- of single reproductions
  genes_changed_mean  REAL NOT NULL,     -- of all traits
  genes_changed_sd    REAL NOT NULL,
  PRIMARY KEY (treatment, profile, mutation_rate)
) WITHOUT ROWID;

-- The tables above without former champions, with results.
CREATE VIEW champion_variants AS
  SELECT v.*, )" RESULTS R"( FROM variants AS v JOIN champions USING (arm, trial, id) )" AS_EVOLVED R"(;
CREATE VIEW champion_walks AS
  SELECT s.*, )" RESULTS R"( FROM walk_steps AS s JOIN champions USING (arm, trial, id) )" AS_EVOLVED R"(;
CREATE VIEW champion_ancestors AS
  SELECT a.*, )" RESULTS R"( FROM ancestors AS a
  JOIN champions AS c ON c.arm = a.arm AND c.trial = a.trial AND c.id = a.champion )" AS_EVOLVED R"(;
CREATE VIEW champion_traces AS
  SELECT t.*, )" RESULTS R"( FROM traces AS t JOIN champions USING (arm, trial, id) )" AS_EVOLVED R"(;
CREATE VIEW champion_robustness AS
  SELECT r.*, w.name, w.quantity, w.value, )" RESULTS R"( FROM robustness AS r JOIN champions USING (arm, trial, id)
  JOIN worlds AS w USING (world) JOIN evaluations AS e USING (world, phenotype_hash);
)";
}  // namespace

const char* studyTables()
{
  return TABLES;
}

const FileKind& studyFile()
{
  static const FileKind kind = { 0x64657670, 1, "study" };
  return kind;
}
}  // namespace devo_evo
