#pragma once

#include "archive/connection.h"

#include <string>

namespace devo_evo
{
/// Looks for damage to the file, and for rows that contradict each other without anything being computed.
/// @return what is wrong first; empty if nothing is.
std::string findDamageOf(Connection& connection);
}  // namespace devo_evo
