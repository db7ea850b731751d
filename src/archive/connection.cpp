#include "archive/connection.h"

#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace devo_evo
{
bool Query::next()
{
  column_ = 0;
  return statement_.executeStep();
}

void Query::run()
{
  statement_.exec();
}

SQLite::Column Query::column(int type, const char* type_name)
{
  const SQLite::Column column = statement_.getColumn(column_++);
  if (column.getType() != type)
  {
    throw DamagedArchive(std::string("column '") + column.getName() + "' holds something that is not " + type_name);
  }
  return column;
}

bool Query::skipNull()
{
  if (!statement_.isColumnNull(column_))
  {
    return false;
  }
  ++column_;
  return true;
}

int64_t Query::natural()
{
  constexpr int64_t MAXIMUM = int64_t(1) << 53;  // more than any of ours; exact in whatever reads the file
  const SQLite::Column column = this->column(SQLITE_INTEGER, "an integer");
  const int64_t value = column.getInt64();
  if (value < 0 || value > MAXIMUM)
  {
    throw DamagedArchive(std::string("column '") + column.getName() + "' holds " + std::to_string(value));
  }
  return value;
}

std::optional<int64_t> Query::optionalNatural()
{
  return skipNull() ? std::nullopt : std::optional<int64_t>(natural());
}

double Query::real()
{
  return optionalReal().value_or(std::numeric_limits<double>::quiet_NaN());
}

std::optional<double> Query::optionalReal()
{
  return skipNull() ? std::nullopt : std::optional<double>(column(SQLITE_FLOAT, "a real number").getDouble());
}

std::string Query::text()
{
  return column(SQLITE_TEXT, "text").getString();
}

std::optional<std::string> Query::optionalText()
{
  return skipNull() ? std::nullopt : std::optional<std::string>(text());
}

Blob Query::bytes(const SQLite::Column& column, size_t size) const
{
  const auto* data = static_cast<const uint8_t*>(column.getBlob());
  const auto stored = static_cast<size_t>(column.getBytes());
  if (stored != size)
  {
    throw DamagedArchive(std::string("column '") + column.getName() + "' holds " + std::to_string(stored) +
                         " bytes instead of " + std::to_string(size));
  }
  return Blob(data, data + stored);
}

Blob Query::blob(size_t size)
{
  return bytes(column(SQLITE_BLOB, "a blob"), size);
}

std::optional<Blob> Query::optionalBlob(size_t size)
{
  return skipNull() ? std::nullopt : std::optional<Blob>(blob(size));
}

Hash128 Query::hash()
{
  Hash128 hash{};
  const Blob bytes = blob(hash.size());
  std::copy(bytes.begin(), bytes.end(), hash.begin());
  return hash;
}

void Query::bind(double value)
{
  if (std::isnan(value))
  {
    statement_.bind(++bound_);
  }
  else
  {
    statement_.bind(++bound_, value);
  }
}

void Query::bind(const Blob& value)
{
  statement_.bind(++bound_, value.data(), static_cast<int>(value.size()));
}

void Query::bind(const Hash128& value)
{
  statement_.bind(++bound_, value.data(), static_cast<int>(value.size()));
}

namespace
{
constexpr int STEPS_BETWEEN_LOOKS = 100000;  // about a millisecond
constexpr int LARGEST_VALUE = 8 << 20;       // [bytes]; a genome of 32768 voxels takes 1.25 MiB

/// Reading all that we write takes less than one step a byte.
uint64_t stepsAllowed(const char* path)
{
  constexpr uint64_t least = 1000000;
  constexpr uint64_t steps_per_byte = 16;
  uint64_t bytes = 0;
  for (const std::string& file : { std::string(path), std::string(path) + "-wal" })
  {
    std::error_code error;
    const auto size = std::filesystem::file_size(file, error);
    bytes += error ? 0 : size;
  }
  return least + steps_per_byte * bytes;
}
}  // namespace

Connection::Connection(SQLite::Database database)
  : work_(std::make_unique<Work>(Work{ database.getHandle() })), database_(std::move(database))
{
  sqlite3_limit(work_->database, SQLITE_LIMIT_LENGTH, LARGEST_VALUE);
  sqlite3_progress_handler(work_->database, STEPS_BETWEEN_LOOKS, look, work_.get());
}

int Connection::look(void* work)
{
  Work& done = *static_cast<Work*>(work);
  done.steps += STEPS_BETWEEN_LOOKS;
  return done.steps > stepsAllowed(sqlite3_db_filename(done.database, "main")) ? 1 : 0;
}

SQLite::Statement& Connection::prepared(const std::string& sql)
{
  const auto found = statements_.find(sql);
  return found != statements_.end() ? found->second
                                    : statements_.emplace(sql, SQLite::Statement(database_, sql)).first->second;
}

Snapshot::Snapshot(Connection& connection) : database_(connection.database())
{
  if (sqlite3_get_autocommit(database_.getHandle()) != 0)
  {
    database_.exec("BEGIN");
    began_ = true;
  }
}

Snapshot::~Snapshot()
{
  if (began_)
  {
    database_.tryExec("COMMIT");
  }
}

namespace
{
bool diskIsFull(const std::string& path)
{
  std::error_code error;
  const auto space = std::filesystem::space(std::filesystem::path(path).parent_path(), error);
  return !error && space.available < 65536;
}

std::string adviceFor(const std::string& path, int code)
{
  switch (code)
  {
    case SQLITE_FULL:
      return "there is no space left for it; what was committed is safe: free some space and start again";
    case SQLITE_IOERR:
      return diskIsFull(path) ? adviceFor(path, SQLITE_FULL)
                              : "the disk reports an error; what was committed is safe if the disk is: check it";
    case SQLITE_READONLY:
    case SQLITE_PERM:
      return "it must not be written; check the permissions of the file and its folder";
    case SQLITE_CANTOPEN:
      return "it cannot be opened; check the permissions of the file and its folder";
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "another program keeps it locked; end that program's transaction and start again";
    case SQLITE_NOTADB:
      return "it is not an SQLite database; choose another output folder";
    case SQLITE_CORRUPT:
      return "it is damaged; restore a copy, or save what is left with `sqlite3 FILE .recover`";
    case SQLITE_INTERRUPT:
    case SQLITE_TOOBIG:
      return "it is damaged: there is more to read in it than its size allows; restore a copy";
    case SQLITE_ERROR:
      return "its tables are not those of an archive; restore a copy";
    default:
      return "SQLite refuses";
  }
}
}  // namespace

std::string describeFailure(const std::string& path, const SQLite::Exception& failure)
{
  constexpr int PRIMARY_CODE = 0xff;
  return "archive " + path + ": " + adviceFor(path, failure.getErrorCode() & PRIMARY_CODE) + " (" + failure.what() +
         ")";
}

std::string describeDamage(const std::string& path, const std::string& damage)
{
  return "archive " + path + " is damaged, or was made by a newer devo_evo: " + damage;
}
}  // namespace devo_evo
