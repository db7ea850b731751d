#include "archive/bytes.h"

#include <cstring>

namespace devo_evo
{
namespace
{
constexpr size_t WORD = sizeof(uint64_t);

static_assert(sizeof(double) == WORD, "doubles are 64-bit IEEE-754 numbers");
}  // namespace

Blob hashToBytes(uint64_t hash)
{
  Blob bytes(WORD);
  for (size_t i = 0; i < WORD; ++i)
  {
    bytes[i] = static_cast<uint8_t>(hash >> (8 * (WORD - 1 - i)));
  }
  return bytes;
}

uint64_t hashFromBytes(const Blob& bytes)
{
  uint64_t hash = 0;
  for (const uint8_t byte : bytes)
  {
    hash = hash << 8 | byte;
  }
  return hash;
}

Blob numbersToBytes(const std::vector<double>& numbers)
{
  Blob bytes(WORD * numbers.size());
  for (size_t n = 0; n < numbers.size(); ++n)
  {
    uint64_t bits;
    std::memcpy(&bits, &numbers[n], WORD);
    for (size_t i = 0; i < WORD; ++i)
    {
      bytes[WORD * n + i] = static_cast<uint8_t>(bits >> (8 * i));
    }
  }
  return bytes;
}

std::vector<double> numbersFromBytes(const Blob& bytes)
{
  std::vector<double> numbers(bytes.size() / WORD);
  for (size_t n = 0; n < numbers.size(); ++n)
  {
    uint64_t bits = 0;
    for (size_t i = 0; i < WORD; ++i)
    {
      bits |= static_cast<uint64_t>(bytes[WORD * n + i]) << (8 * i);
    }
    std::memcpy(&numbers[n], &bits, WORD);
  }
  return numbers;
}
}  // namespace devo_evo
