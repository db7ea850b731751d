#include "archive/schema.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>

namespace devo_evo
{
namespace
{
constexpr int BUSY_TIMEOUT_MS = 10000;
constexpr int64_t PAGE_SIZE = 4096;  // [bytes]

// Comments stay in the file: `.schema` shows them. Not STRICT, so that SQLite from before 3.37 reads it too.
const char* const SHARED_TABLES = R"(
CREATE TABLE parameters (  -- of the experiment (docs/parameters.md)
  name  TEXT NOT NULL PRIMARY KEY,
  value TEXT NOT NULL,  -- as one would write it; numbers read back as the same number
  unit  TEXT NOT NULL   -- '' if it has none
) WITHOUT ROWID;

CREATE TABLE starts (  -- each time that an evolver opened this archive: where results were made
  number             INTEGER PRIMARY KEY,  -- counts up from 1
  time_utc           TEXT NOT NULL,        -- 2018-04-17T12:34:56Z
  version            TEXT NOT NULL,        -- of devo_evo
  compiler           TEXT NOT NULL,
  processor          TEXT NOT NULL,
  instruction_set    TEXT NOT NULL,
  host               TEXT NOT NULL,
  engine_fingerprint BLOB,                 -- 8 bytes; equal for engines that give equal results; NULL: not known
  ros                TEXT NOT NULL DEFAULT ''  -- version of roscpp; '' for a program without ROS
);
)";

int64_t pragma(Connection& connection, const std::string& name)
{
  return connection.database().execAndGet("PRAGMA " + name).getInt64();
}

bool isEmpty(Connection& connection)
{
  return connection.database().execAndGet("SELECT count(*) FROM sqlite_master").getInt64() == 0 &&
         pragma(connection, "application_id") == 0;
}

/// As a URI, in which some characters have a meaning of their own.
std::string immutableUri(const std::string& path)
{
  constexpr char DIGITS[] = "0123456789abcdef";
  std::string uri = "file:";
  for (const char character : path)
  {
    const auto byte = static_cast<unsigned char>(character);
    if (std::string("%?#").find(character) != std::string::npos)
    {
      uri += { '%', DIGITS[byte >> 4], DIGITS[byte & 15] };
    }
    else
    {
      uri += character;
    }
  }
  return uri + "?immutable=1";
}

/// Reads one page, to find out whether reading works.
bool isReadable(SQLite::Database& database)
{
  return database.tryExec("SELECT count(*) FROM sqlite_master") == SQLite::OK;
}

void distrustSchema(SQLite::Database& database)
{
  database.exec("PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON;");
}

/// A writer that is killed while it makes the file, or turns it into one plain file at the end, leaves a journal.
/// SQLite undoes what is in it when somebody opens the file who may write.
void undoWhatAKilledWriterBegan(const std::string& path)
{
  std::error_code error;
  if (std::filesystem::exists(path + "-journal", error) && access(path.c_str(), W_OK) == 0)
  {
    SQLite::Database database(path, SQLite::OPEN_READWRITE, BUSY_TIMEOUT_MS);
    distrustSchema(database);
    isReadable(database);
  }
}
}  // namespace

const FileKind& experimentFile()
{
  static const FileKind kind = { 0x6465766f, 1, "experiment" };
  return kind;
}

Connection connectForWriting(const std::string& path, int64_t maximum_size, const FileKind& kind)
{
  SQLite::Database database(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, BUSY_TIMEOUT_MS);
  distrustSchema(database);
  Connection connection(std::move(database));
  if (!isEmpty(connection))
  {
    checkSchema(connection, path, kind);  // before anything is changed in it
  }
  if (connection.database().execAndGet("PRAGMA journal_mode = WAL").getString() != "wal")
  {
    throw ArchiveError("archive " + path +
                       ": this file system cannot hold it, since it lacks shared memory for SQLite's "
                       "write-ahead log; choose an output folder on a local disk");
  }
  connection.database().exec("PRAGMA synchronous = FULL; PRAGMA secure_delete = OFF;");
  if (maximum_size > 0)
  {
    const int64_t pages = std::max<int64_t>(1, maximum_size / PAGE_SIZE);
    connection.database().exec("PRAGMA max_page_count = " + std::to_string(pages));
  }
  return connection;
}

void leaveOneFile(Connection& connection)
{
  connection.database().tryExec("PRAGMA busy_timeout = 1000; PRAGMA journal_mode = DELETE");
  connection.database().tryExec("PRAGMA wal_checkpoint(TRUNCATE)");
}

Connection connectForReading(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::exists(path, error))
  {
    throw ArchiveError("there is no archive " + path + (error ? " to be seen (" + error.message() + ")" : "") +
                       "; name the output folder of an experiment");
  }
  undoWhatAKilledWriterBegan(path);
  SQLite::Database database(path, SQLite::OPEN_READONLY, BUSY_TIMEOUT_MS);
  const std::string folder = std::filesystem::path(path).parent_path().string();
  if (!isReadable(database) && access(folder.c_str(), W_OK) != 0)
  {
    // In a folder that must not be written, SQLite cannot set up the memory that readers share with a writer. Without a
    // log (as in a copy made while nothing was written) there is no writer, and none is needed.
    const std::string log = path + "-wal";
    if (std::filesystem::exists(log, error) && std::filesystem::file_size(log, error) != 0)
    {
      throw ArchiveError(
          "archive " + path + ": its last generations are in " + log +
          ", which cannot be read in a folder that must not be written; copy both files to one that can");
    }
    database = SQLite::Database(immutableUri(path), SQLite::OPEN_READONLY | SQLite::OPEN_URI);
  }
  distrustSchema(database);
  return Connection(std::move(database));
}

bool hasTable(Connection& connection, const std::string& table)
{
  return connection.query("SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = ?", table).next();
}

bool hasColumn(Connection& connection, const std::string& table, const std::string& column)
{
  return connection.query("SELECT 1 FROM pragma_table_info(?) WHERE name = ?", table, column).next();
}

bool createSchema(Connection& connection, const FileKind& kind, const std::string& tables)
{
  if (!isEmpty(connection))
  {
    return false;
  }
  connection.database().exec(SHARED_TABLES);
  connection.database().exec(tables);
  connection.database().exec("PRAGMA application_id = " + std::to_string(kind.application_id));
  connection.database().exec("PRAGMA user_version = " + std::to_string(kind.version));
  return true;
}

bool hasBegun(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::exists(path, error) && !error)
  {
    return false;
  }
  const auto look = [&]
  {
    Connection connection = connectForReading(path);
    return !isEmpty(connection);
  };
  return guarded(path, look);
}

void checkSchema(Connection& connection, const std::string& path, const FileKind& kind)
{
  if (isEmpty(connection))
  {
    throw ArchiveError("archive " + path + " is empty: its " + kind.name + " has not begun");
  }
  if (pragma(connection, "application_id") != kind.application_id)
  {
    throw ArchiveError("archive " + path + ": it is a database of another program; choose another output folder");
  }
  const int64_t version = pragma(connection, "user_version");
  if (version != kind.version)
  {
    throw ArchiveError("archive " + path + ": its tables are of version " + std::to_string(version) +
                       ", of which this devo_evo knows only " + std::to_string(kind.version) +
                       "; use the devo_evo that made it, or a newer one");
  }
}
}  // namespace devo_evo
