#include "state_hash.h"

#include <openssl/evp.h>

#include <array>
#include <cstring>
#include <stdexcept>

namespace devo_evo
{
void StateHash::add(double number)
{
  const double without_negative_zero = number + 0.0;
  uint64_t bits;
  std::memcpy(&bits, &without_negative_zero, sizeof bits);
  add(bits);
}

void StateHash::add(bool flag)
{
  bytes_.push_back(flag ? 1 : 0);
}

void StateHash::add(uint64_t bits)
{
  for (int shift = 0; shift < 64; shift += 8)
  {
    bytes_.push_back(static_cast<uint8_t>(bits >> shift));
  }
}

uint64_t StateHash::value() const
{
  std::array<uint8_t, EVP_MAX_MD_SIZE> digest{};
  if (EVP_Digest(bytes_.data(), bytes_.size(), digest.data(), nullptr, EVP_sha256(), nullptr) != 1)
  {
    throw std::runtime_error("OpenSSL could not compute SHA-256");
  }
  uint64_t value = 0;
  for (size_t i = 0; i < 8; ++i)
  {
    value = value << 8 | digest[i];
  }
  return value;
}
}  // namespace devo_evo
