#pragma once

#include "archive/connection.h"

#include <optional>

namespace devo_evo
{
/// Looks for damage to the file, and for rows that contradict each other without anything being computed.
/// @return what is wrong first; none if nothing is.
std::optional<Offence> findDamageOf(Connection& connection);
}  // namespace devo_evo
