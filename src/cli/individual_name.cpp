#include "cli/individual_name.h"

#include <charconv>

namespace devo_evo
{
namespace
{
std::optional<int64_t> naturalNumber(const std::string& text)
{
  int64_t number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stop == end && number >= 0 ? std::optional<int64_t>(number) : std::nullopt;
}
}  // namespace

std::pair<int64_t, int64_t> readIndividualName(const Archive& archive, const std::string& name)
{
  const size_t slash = name.find('/');
  const auto trial = naturalNumber(name.substr(0, slash));
  const auto id = slash == std::string::npos ? std::nullopt : naturalNumber(name.substr(slash + 1));
  if (!trial || (slash != std::string::npos && !id))
  {
    throw InvalidInput("\"" + name + "\" names no individual; write TRIAL/ID, like 3/1042, or TRIAL for its champion");
  }
  return { *trial, id ? *id : archive.championOf(*trial) };
}
}  // namespace devo_evo
