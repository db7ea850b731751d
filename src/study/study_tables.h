#pragma once

#include "archive/schema.h"

namespace devo_evo
{
/// `study.db`.
const FileKind& studyFile();
}  // namespace devo_evo
