#pragma once

#include <cstdint>
#include <string>

namespace devo_evo
{
/// The shortest text that reads back as the same number, whatever the locale.
std::string toText(double number);
std::string toText(int64_t number);
inline std::string toText(int number)
{
  return toText(static_cast<int64_t>(number));
}

/// A number with a fixed count of decimals, whatever the locale; "-" if it is not finite.
std::string fixedText(double number, int decimals);

/// A hash as people see it: 16 lower-case hexadecimal digits.
std::string hashToString(uint64_t hash);
}  // namespace devo_evo
