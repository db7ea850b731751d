#include "study/study_database.h"

#include "archive/bytes.h"
#include "archive/evaluation_columns.h"
#include "archive/schema.h"
#include "archive/settings_table.h"
#include "archive/start_table.h"
#include "study/study_tables.h"

#include <nlohmann/json.hpp>

namespace devo_evo
{
namespace
{
std::string settingsText(const SoftBodySettings& body)
{
  Parameters parameters;
  parameters.experiment.body = BodySettings(body);
  nlohmann::ordered_json settings = nlohmann::ordered_json::object();
  for (const ParameterSpec& spec : parameterSpecs())
  {
    if (describesBody(spec, BodyKind::SOFT) && spec.body)
    {
      const std::string value = spec.get(parameters);
      const auto parsed = nlohmann::ordered_json::parse(value, nullptr, false);
      settings[spec.name] = parsed.is_discarded() ? nlohmann::ordered_json(value) : parsed;
    }
  }
  return settings.dump();
}

std::string rateText(const EvolutionSettings& settings)
{
  Parameters parameters;
  parameters.experiment.evolution = settings;
  return parameterSpec("mutation_rate").get(parameters);
}

std::optional<Blob> velocitiesOf(const Evaluation& evaluation, bool wanted)
{
  return wanted && evaluation.valid ? std::optional(numbersToBytes(evaluation.velocity_body_lengths_per_s))
                                    : std::nullopt;
}
}  // namespace

std::string studyDatabasePath(const std::string& output)
{
  return output + "/study.db";
}

StudyDatabase::StudyDatabase(const Parameters& parameters, const Provenance& provenance)
  : path_(studyDatabasePath(parameters.experiment.output))
{
  makeOutputFolder(parameters.experiment.output);
  lock_ = std::make_unique<WriterLock>(parameters.experiment.output);
  guarded(path_,
          [&]
          {
            connection_ = std::make_unique<Connection>(connectForWriting(path_, 0, studyFile()));
            begin(parameters, provenance);
          });
}

StudyDatabase::~StudyDatabase()
{
  if (connection_)
  {
    leaveOneFile(*connection_);
  }
}

void StudyDatabase::begin(const Parameters& parameters, const Provenance& provenance)
{
  SQLite::Transaction transaction(connection_->database(), SQLite::TransactionBehavior::IMMEDIATE);
  if (!createSchema(*connection_, studyFile(), studyTables()))
  {
    checkResumable(*connection_, parameters.experiment, studiedBodies());
  }
  writeSettings(*connection_, parameters.experiment, studiedBodies());
  for (const ParameterSpec& spec : parameterSpecs())
  {
    if (spec.group == "study")
    {
      writeParameter(*connection_, spec, parameters);
    }
  }
  recordStart(*connection_, provenance);
  start_ = number("SELECT max(number) FROM starts");
  transaction.commit();
}

void StudyDatabase::putArm(const Arm& arm)
{
  const EvolutionSettings& evolution = arm.settings.evolution;
  run("INSERT OR REPLACE INTO arms (arm, part, treatment, profile, mutation_rate, selection, trials, generations) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
      arm.name, toString(arm.part), toString(evolution.treatment), toString(evolution.profile), rateText(evolution),
      toString(evolution.selection), arm.settings.trials, arm.settings.generations);
}

void StudyDatabase::putChampion(const std::string& arm, const Individual& champion, int64_t generation)
{
  run("INSERT OR REPLACE INTO champions (arm, trial, id, generation, fitness) VALUES (?, ?, ?, ?, ?)", arm,
      champion.trial, champion.id, generation, champion.evaluation.value().fitness);
}

int64_t StudyDatabase::numberOf(const World& world)
{
  run("INSERT OR IGNORE INTO worlds (name, quantity, value, settings) VALUES (?, ?, ?, ?)", world.name, world.quantity,
      world.value, settingsText(world.body));
  return number("SELECT world FROM worlds WHERE name = ?", world.name);
}

bool StudyDatabase::hasEvaluation(int64_t world, const Hash128& phenotype, bool with_velocities)
{
  return number(
             "SELECT count(*) FROM evaluations WHERE world = ? AND phenotype_hash = ? AND (velocities IS NOT NULL OR "
             "NOT valid OR NOT ?)",
             world, phenotype, with_velocities ? 1 : 0) > 0;
}

void StudyDatabase::putEvaluation(int64_t world, const Hash128& phenotype, const Evaluation& evaluation,
                                  bool with_velocities)
{
  static const std::shared_ptr<const Body> body = makeSoftBody(SoftBodySettings());
  const std::string sql = "INSERT OR REPLACE INTO evaluations (world, phenotype_hash, start, velocities, " +
                          evaluationColumns(*body) + ") VALUES (?, ?, ?, ?, " + evaluationMarks(*body) + ")";
  guarded(path_,
          [&]
          {
            connection_->beginWork();
            Query query = connection_->query(sql, world, phenotype, start_, velocitiesOf(evaluation, with_velocities));
            bindEvaluation(query, *body, evaluation);
            query.run();
          });
}

void StudyDatabase::checkReproduced(int64_t world, const Hash128& phenotype, const Evaluation& archived,
                                    const std::string& name)
{
  const auto hash = archived.valid ? std::optional<Blob>(hashToBytes(archived.state_hash)) : std::nullopt;
  if (number("SELECT count(*) FROM evaluations WHERE world = ? AND phenotype_hash = ? AND state_hash IS ?", world,
             phenotype, hash) == 0)
  {
    throw ArchiveError(name + " ended otherwise when it was simulated again than its archive says; its archive was " +
                       "changed, or made by another engine: run the study in a new folder");
  }
}
}  // namespace devo_evo
