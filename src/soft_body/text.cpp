#include "devo_evo/soft_body/text.h"

#include <charconv>
#include <cmath>

namespace devo_evo
{
namespace
{
template <class Number>
std::string shortestText(Number number)
{
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, number).ptr);
}
}  // namespace

std::string toText(double number)
{
  return shortestText(number);
}

std::string toText(int64_t number)
{
  return shortestText(number);
}

std::string fixedText(double number, int decimals)
{
  if (!std::isfinite(number))
  {
    return "-";
  }
  char text[512];  // the largest double has 309 digits before the point
  const auto result = std::to_chars(text, text + sizeof text, number, std::chars_format::fixed, decimals);
  return std::string(text, result.ptr);
}

std::string hashToString(uint64_t hash)
{
  std::string digits(16, '0');
  for (size_t i = 16; i > 0; --i, hash >>= 4)
  {
    digits[i - 1] = "0123456789abcdef"[hash & 0xf];
  }
  return digits;
}
}  // namespace devo_evo
