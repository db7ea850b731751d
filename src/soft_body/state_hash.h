#pragma once

#include <cstdint>
#include <vector>

namespace devo_evo
{
/// The first 64 bits of SHA-256 over numbers, each as a little-endian double, and flags, each as one byte of 0 or 1.
/// Negative zero counts as zero.
class StateHash
{
public:
  void add(double number);
  void add(bool flag);
  void add(uint64_t bits);
  uint64_t value() const;

private:
  std::vector<uint8_t> bytes_;
};
}  // namespace devo_evo
