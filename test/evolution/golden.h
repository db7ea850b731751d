#pragma once

#include "soft_body/sha256.h"

#include <string>

namespace devo_evo
{
/// First 64 bits of the hash as 16 hexadecimal digits: enough to compare with a value noted in a test.
inline std::string digestOf(Sha256& hash)
{
  const std::array<uint8_t, 32> bytes = hash.finish();
  std::string digits;
  for (size_t i = 0; i < 8; ++i)
  {
    digits += "0123456789abcdef"[bytes[i] >> 4];
    digits += "0123456789abcdef"[bytes[i] & 0xf];
  }
  return digits;
}
}  // namespace devo_evo
