#pragma once

#include "archive/schema.h"

namespace devo_evo
{
/// `study.db`.
const FileKind& studyFile();

/// SQL that makes its tables.
const char* studyTables();
}  // namespace devo_evo
