#pragma once

#include "archive/connection.h"
#include "archive/output_folder.h"
#include "devo_evo/experiment/parameters.h"
#include "study/arms.h"
#include "study/worlds.h"

#include <memory>
#include <string>

namespace devo_evo
{
/// Path of what a study simulates for its analyses, in the study's folder.
std::string studyDatabasePath(const std::string& output);

/// `study.db` (docs/study.md): what a study simulates for its analyses. Calls throw ArchiveError if the file cannot be
/// written or holds what we never write.
class StudyDatabase
{
public:
  /// Opens it, or makes it. @param parameters experiment.output is the study's folder.
  /// @throw ArchiveError as openArchiveForWriting().
  StudyDatabase(const Parameters& parameters, const Provenance& provenance);
  ~StudyDatabase();
  StudyDatabase(const StudyDatabase&) = delete;
  StudyDatabase& operator=(const StudyDatabase&) = delete;

  void putArm(const Arm& arm);

  /// Notes whom analyses are about. @param generation the trial's last.
  void putChampion(const std::string& arm, const Individual& champion, int64_t generation);

  /// The world's number; it is added if need be.
  int64_t numberOf(const World& world);

  bool hasEvaluation(int64_t world, const Hash128& phenotype, bool with_velocities);
  void putEvaluation(int64_t world, const Hash128& phenotype, const Evaluation& evaluation, bool with_velocities);

  /// @throw ArchiveError if the robot's result in this world is not the one that its archive holds.
  void checkReproduced(int64_t world, const Hash128& phenotype, const Evaluation& archived, const std::string& name);

  /// Runs a statement that gives no rows. @param values bound to its parameters.
  template <class... Values>
  void run(const char* sql, const Values&... values)
  {
    guarded(path_,
            [&]
            {
              connection_->beginWork();
              connection_->query(sql, values...).run();
            });
  }

  /// The only value of a query, a whole number.
  template <class... Values>
  int64_t number(const char* sql, const Values&... values)
  {
    return guarded(path_,
                   [&]
                   {
                     connection_->beginWork();
                     Query query = connection_->query(sql, values...);
                     query.next();
                     return query.natural();
                   });
  }

  /// What `change` does is written as a whole or not at all, and is on disk when this returns.
  template <class Change>
  void inTransaction(Change&& change)
  {
    guarded(path_,
            [&]
            {
              SQLite::Transaction transaction(connection_->database(), SQLite::TransactionBehavior::IMMEDIATE);
              change();
              transaction.commit();
            });
  }

private:
  void begin(const Parameters& parameters, const Provenance& provenance);

  const std::string path_;
  std::unique_ptr<WriterLock> lock_;
  std::unique_ptr<Connection> connection_;
  int64_t start_ = 0;
};
}  // namespace devo_evo
