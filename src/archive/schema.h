#pragma once

#include "archive/connection.h"

#include <string>

namespace devo_evo
{
/// Marks an SQLite file as ours ("devo" in ASCII), and tells the versions of its tables apart.
constexpr int64_t APPLICATION_ID = 0x6465766f;
constexpr int64_t SCHEMA_VERSION = 1;

/// Opens the file for writing and sets it up to survive a crash; makes an empty file if there is none.
/// @param maximum_size beyond which the file must not grow [bytes]; 0: no limit.
/// @throw ArchiveError as checkSchema(), but takes an empty file.
Connection connectForWriting(const std::string& path, int64_t maximum_size);

/// Opens an existing file for reading. @throw ArchiveError if there is none.
Connection connectForReading(const std::string& path);

/// Makes the tables in a new file. @return false if there are tables already.
bool createSchema(Connection& connection);

/// @throw ArchiveError if the file is empty, not ours, or of a newer version.
void checkSchema(Connection& connection, const std::string& path);
}  // namespace devo_evo
