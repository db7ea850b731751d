#pragma once

#include "archive/connection.h"

#include <string>

namespace devo_evo
{
/// SHA-256 over what evolution decided, as docs/archive.md ("Digest") describes it; 64 hexadecimal digits.
std::string computeDigest(Connection& connection);
}  // namespace devo_evo
