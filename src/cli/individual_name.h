#pragma once

#include "devo_evo/archive/archive.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace devo_evo
{
/// "3/1042", or "3" for the champion of trial 3. @return trial and id.
/// @throw InvalidInput if it is written in another way, or the trial has no champion.
std::pair<int64_t, int64_t> readIndividualName(const Archive& archive, const std::string& name);
}  // namespace devo_evo
