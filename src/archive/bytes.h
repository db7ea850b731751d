#pragma once

#include "archive/connection.h"

#include <cstdint>
#include <vector>

namespace devo_evo
{
/// A 64-bit hash as 8 bytes, the highest first, so that SQL's hex() shows it as people see it.
Blob hashToBytes(uint64_t hash);
uint64_t hashFromBytes(const Blob& bytes);

/// Numbers as IEEE-754 doubles in little endian, 8 bytes each.
Blob numbersToBytes(const std::vector<double>& numbers);
std::vector<double> numbersFromBytes(const Blob& bytes);
}  // namespace devo_evo
