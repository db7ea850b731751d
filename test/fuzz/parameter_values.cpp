// One value of one parameter, as launch files, command lines and the parameter server give it: a line with the
// parameter's name, a byte that chooses the type of the value, and the value.

#include "devo_evo/experiment/parameters.h"
#include "fuzz/input.h"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace devo_evo::fuzz
{
namespace
{
template <class Number>
Number numberFrom(std::string_view bytes)
{
  Number number{};
  std::memcpy(&number, bytes.data(), std::min(bytes.size(), sizeof(number)));
  return number;
}

std::vector<int64_t> listFrom(std::string_view bytes)
{
  std::vector<int64_t> list;
  for (; bytes.size() >= sizeof(int64_t); bytes.remove_prefix(sizeof(int64_t)))
  {
    list.push_back(numberFrom<int64_t>(bytes));
  }
  return list;
}

/// @param type chooses as in the order of ParameterValue: 'b', 'i', 'r', 't' or 'l'; others are text too.
ParameterValue valueFrom(char type, std::string_view bytes)
{
  switch (type)
  {
    case 'b':
      return !bytes.empty() && bytes.front() % 2 != 0;
    case 'i':
      return numberFrom<int64_t>(bytes);
    case 'r':
      return numberFrom<double>(bytes);
    case 'l':
      return listFrom(bytes);
    default:
      return std::string(bytes);
  }
}

void setOne(const ParameterSpec& spec, const ParameterValue& value)
{
  Parameters parameters;
  spec.set(parameters, value);
  // Whatever is accepted can be written down, and reads back as the same.
  const std::string text = spec.get(parameters);
  Parameters back;
  if (text != spec.get(back))
  {
    spec.set(back, text);
  }
  require(spec.get(back) == text);
}
}  // namespace

Refusal handle(const uint8_t* data, size_t size)
{
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const size_t end_of_name = input.find('\n');
  if (end_of_name == std::string_view::npos || end_of_name + 1 == size)
  {
    return "there is no name, or no value";
  }
  try
  {
    setOne(parameterSpec(std::string(input.substr(0, end_of_name))),
           valueFrom(input[end_of_name + 1], input.substr(end_of_name + 2)));
  }
  catch (const InvalidInput& e)
  {
    return e.what();
  }
  return std::nullopt;
}
}  // namespace devo_evo::fuzz
