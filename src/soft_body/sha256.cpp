#include "soft_body/sha256.h"

#include <openssl/evp.h>

#include <cstring>
#include <stdexcept>

namespace devo_evo
{
namespace
{
void check(int result)
{
  if (result != 1)
  {
    throw std::runtime_error("OpenSSL cannot compute SHA-256");
  }
}
}  // namespace

Sha256::Sha256() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free)
{
  check(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr));
}

Sha256::~Sha256() = default;

Sha256& Sha256::add(const void* bytes, size_t count)
{
  check(EVP_DigestUpdate(context_.get(), bytes, count));
  return *this;
}

Sha256& Sha256::add(uint64_t number)
{
  std::array<uint8_t, 8> bytes;
  for (uint8_t& byte : bytes)
  {
    byte = static_cast<uint8_t>(number);
    number >>= 8;
  }
  return add(bytes.data(), bytes.size());
}

Sha256& Sha256::add(double number)
{
  uint64_t bits;
  std::memcpy(&bits, &number, sizeof bits);
  return add(bits);
}

Sha256& Sha256::add(const std::vector<double>& numbers)
{
  add(static_cast<uint64_t>(numbers.size()));
  for (const double number : numbers)
  {
    add(number);
  }
  return *this;
}

std::array<uint8_t, 32> Sha256::finish()
{
  std::array<uint8_t, 32> hash;
  check(EVP_DigestFinal_ex(context_.get(), hash.data(), nullptr));
  return hash;
}
}  // namespace devo_evo
