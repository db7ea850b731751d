#pragma once

#include "soft_body/sha256.h"

#include <cstdint>

namespace devo_evo
{
/// The first 64 bits of SHA-256 over numbers, each as a little-endian double, and flags, each as one byte of 0 or 1.
/// Negative zero counts as zero.
class StateHash
{
public:
  void add(double number) { sha_.add(number + 0.0); }
  void add(bool flag);
  void add(uint64_t bits) { sha_.add(bits); }

  /// Nothing can be added after it.
  uint64_t finish();

private:
  Sha256 sha_;
};
}  // namespace devo_evo
