#pragma once

#include "devo_evo/archive/archive.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

namespace devo_evo
{
using Blob = std::vector<uint8_t>;

/// Thrown inside the archive when the file holds something that we never write; the file's name is added by guarded().
class DamagedArchive : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A statement in use: its parameters are bound, its rows read one by one, their columns from left to right. The
/// statement is reset at the end, so that it holds no lock and can be used again.
class Query
{
public:
  template <class... Values>
  explicit Query(SQLite::Statement& statement, const Values&... values) : statement_(statement)
  {
    statement_.tryReset();
    (bind(values), ...);
  }
  ~Query() { statement_.tryReset(); }
  Query(const Query&) = delete;
  Query& operator=(const Query&) = delete;

  /// Binds the next parameter.
  template <class Value>
  Query& with(const Value& value)
  {
    bind(value);
    return *this;
  }

  /// Goes to the next row. @return false if there is none.
  bool next();

  /// Runs a statement that gives no rows.
  void run();

  /// The present row's next column. @throw DamagedArchive if it is of another type.
  int64_t natural();                         ///< @throw DamagedArchive also unless it is within 0 to 2^53
  std::optional<int64_t> optionalNatural();  ///< NULL: none
  double real();                             ///< NULL: NaN
  std::optional<double> optionalReal();      ///< NULL: none
  std::string text();
  std::optional<std::string> optionalText();      ///< NULL: none
  Blob blob(size_t size);                         ///< @throw DamagedArchive also if it has another size
  std::optional<Blob> optionalBlob(size_t size);  ///< NULL: none
  Hash128 hash();

private:
  void bind(int64_t value) { statement_.bind(++bound_, value); }
  void bind(int value) { statement_.bind(++bound_, value); }
  void bind(double value);  ///< NaN: NULL
  void bind(const std::string& value) { statement_.bind(++bound_, value); }
  void bind(const Blob& value);
  void bind(const Hash128& value);
  template <class Value>
  void bind(const std::optional<Value>& value)  ///< none: NULL
  {
    if (value)
    {
      bind(*value);
    }
    else
    {
      statement_.bind(++bound_);
    }
  }

  SQLite::Column column(int type, const char* type_name);
  bool skipNull();
  Blob bytes(const SQLite::Column& column, size_t size) const;

  SQLite::Statement& statement_;
  int bound_ = 0;
  int column_ = 0;
};

/// An SQLite connection with its prepared statements. No file can keep it busy for ever, or fill the memory: what is
/// done in one go is bounded by the file's size, values by what the largest of ours take. SQLite refuses what is
/// beyond.
class Connection
{
public:
  explicit Connection(SQLite::Database database);

  SQLite::Database& database() { return database_; }

  /// Begins something new, to which the bound applies afresh.
  void beginWork() { work_->steps = 0; }

  /// Starts a query; the statement is prepared once. @pre no other query of the same text is in use.
  template <class... Values>
  Query query(const std::string& sql, const Values&... values)
  {
    return Query(prepared(sql), values...);
  }

private:
  /// What has been done since beginWork(), in steps of SQLite's machine.
  struct Work
  {
    sqlite3* database;
    uint64_t steps = 0;
  };

  /// Called by SQLite every now and then. @return whether to stop, 0 or 1.
  static int look(void* work);

  SQLite::Statement& prepared(const std::string& sql);

  std::unique_ptr<Work> work_;
  SQLite::Database database_;
  std::unordered_map<std::string, SQLite::Statement> statements_;  // by their text
};

/// A view of the archive that does not change while it is read, even if a generation is committed meanwhile.
/// Inside another transaction it does nothing.
class Snapshot
{
public:
  explicit Snapshot(Connection& connection);
  ~Snapshot();
  Snapshot(const Snapshot&) = delete;
  Snapshot& operator=(const Snapshot&) = delete;

private:
  SQLite::Database& database_;
  bool began_ = false;
};

/// For people: what went wrong with the file at `path`, and what would help.
std::string describeFailure(const std::string& path, const SQLite::Exception& failure);
std::string describeDamage(const std::string& path, const std::string& damage);

/// Runs an operation on the file at `path`; failures of SQLite become ArchiveErrors.
template <class Operation>
auto guarded(const std::string& path, Operation&& operation)
{
  try
  {
    return operation();
  }
  catch (const SQLite::Exception& failure)
  {
    throw ArchiveError(describeFailure(path, failure));
  }
  catch (const DamagedArchive& damage)
  {
    throw ArchiveError(describeDamage(path, damage.what()));
  }
}
}  // namespace devo_evo
