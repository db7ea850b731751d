#pragma once

#include "archive/archived_body.h"
#include "archive/connection.h"
#include "archive/output_folder.h"

#include <memory>
#include <utility>
#include <vector>

namespace devo_evo
{
/// The archive as one SQLite file. Its tables are described in docs/archive.md.
class SqliteArchive : public Archive
{
public:
  /// @param connection to a file that holds our tables and parameters.
  /// @param lock       of the one who writes; none: only for reading.
  SqliteArchive(const std::string& output, Connection connection, std::unique_ptr<WriterLock> lock);
  ~SqliteArchive() override;

  void commitGenerations(const std::vector<GenerationRecord>& records) override;
  void noteEvaluators(std::vector<Evaluator> evaluators) override { evaluators_ = std::move(evaluators); }
  std::optional<Evaluation> findEvaluation(const Hash128& phenotype_hash) const override;
  std::map<int64_t, TrialState> trialStates() const override;
  ArchivedIndividual readIndividual(int64_t trial, int64_t id) const override;
  std::vector<ArchivedIndividual> readLineage(int64_t trial, int64_t id) const override;
  int64_t championOf(int64_t trial) const override;
  std::vector<int64_t> trials() const override;
  TrialExtent extentOf(int64_t trial) const override;
  std::vector<ArchivedIndividual> readIndividuals(int64_t trial, int64_t first_id, int64_t count) const override;
  std::optional<ArchivedSelection> readSelection(int64_t trial, int64_t generation) const override;
  std::vector<Start> starts() const override;
  std::optional<Offence> findDamage() const override;
  ExperimentSettings settings() const override;
  std::string digest() const override;

private:
  /// Runs an operation on the file. @throw ArchiveError for failures of SQLite and damage.
  template <class Operation>
  auto working(Operation operation) const
  {
    connection_.beginWork();
    return guarded(path_, operation);
  }

  /// Runs an operation on one unchanging view of the file. @throw ArchiveError for failures of SQLite and damage.
  template <class Operation>
  auto reading(Operation operation) const
  {
    const auto operation_on_snapshot = [&]
    {
      const Snapshot snapshot(connection_);
      return operation();
    };
    return working(operation_on_snapshot);
  }

  void checkWritable() const;
  void noteStop() noexcept;
  void write(const std::vector<GenerationRecord>& records);
  TrialState stateOf(int64_t trial) const;
  Individual survivor(int64_t trial, int64_t id, int64_t generation) const;
  std::vector<ArchivedIndividual> descent(int64_t trial, int64_t id, bool all_ancestors) const;

  const std::string output_;
  const std::string path_;
  const std::pair<uint64_t, uint64_t> file_;  // its identity
  std::unique_ptr<WriterLock> lock_;          // outlives the connection
  mutable Connection connection_;
  ExperimentSettings settings_;
  ArchivedBody body_;
  std::vector<Evaluator> evaluators_;
};
}  // namespace devo_evo
