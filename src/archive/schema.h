#pragma once

#include "archive/connection.h"

#include <string>

namespace devo_evo
{
/// A kind of SQLite file of ours. All have the tables `parameters` and `starts`.
struct FileKind
{
  int64_t application_id;  ///< marks it as ours, and of this kind
  int64_t version;         ///< of its tables
  std::string name;        ///< of what it holds, for messages
};

/// `experiment.db`: application_id is "devo" in ASCII.
const FileKind& experimentFile();

/// Opens the file for writing and sets it up to survive a crash; makes an empty file if there is none.
/// @param maximum_size beyond which the file must not grow [bytes]; 0: no limit.
/// @throw ArchiveError as checkSchema(), but takes an empty file.
Connection connectForWriting(const std::string& path, int64_t maximum_size, const FileKind& kind = experimentFile());

/// At the end of writing: leaves one plain file, which anything can read anywhere; with somebody reading, at least its
/// log is empty.
void leaveOneFile(Connection& connection);

/// Opens an existing file for reading. @throw ArchiveError if there is none.
Connection connectForReading(const std::string& path);

/// Whether anything was ever committed to the file. Whoever is killed between making it and that leaves an empty one,
/// which is as good as none. @throw ArchiveError if it cannot be read.
bool hasBegun(const std::string& path);

/// Makes the tables in a new file. @param tables SQL that makes those besides the shared ones.
/// @return false if there are tables already.
bool createSchema(Connection& connection, const FileKind& kind, const std::string& tables);

/// Archives from before have neither all tables nor all columns.
bool hasTable(Connection& connection, const std::string& table);
bool hasColumn(Connection& connection, const std::string& table, const std::string& column);

/// @throw ArchiveError if the file is empty, not ours, or of a newer version.
void checkSchema(Connection& connection, const std::string& path, const FileKind& kind = experimentFile());
}  // namespace devo_evo
