#pragma once

#include "archive/connection.h"

#include <string>

namespace devo_evo
{
/// SQL that makes the tables of an experiment with this body.
std::string experimentTables(const Body& body);

/// Adds to an experiment's file what those from before have not.
void addLaterTables(Connection& connection, const Body& body);
}  // namespace devo_evo
