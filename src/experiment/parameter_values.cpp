#include "experiment/parameter_values.h"

#include "devo_evo/soft_body/text.h"

#include <algorithm>
#include <charconv>

namespace devo_evo
{
namespace
{
template <class Number>
std::optional<Number> parseNumber(const std::string& text)
{
  Number number{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stop == end ? std::optional<Number>(number) : std::nullopt;
}

template <class Type>
std::optional<Type> asExactly(const ParameterValue& value)
{
  const auto* typed = std::get_if<Type>(&value);
  return typed ? std::optional<Type>(*typed) : std::nullopt;
}
}  // namespace

std::optional<std::string> asText(const ParameterValue& value)
{
  return asExactly<std::string>(value);
}

std::optional<bool> asBoolean(const ParameterValue& value)
{
  const auto text = asText(value);
  if (text == "true" || text == "false")
  {
    return text == "true";
  }
  return asExactly<bool>(value);
}

std::optional<int64_t> asInteger(const ParameterValue& value)
{
  const auto text = asText(value);
  return text ? parseNumber<int64_t>(*text) : asExactly<int64_t>(value);
}

std::optional<double> asReal(const ParameterValue& value)
{
  if (const auto text = asText(value))
  {
    return parseNumber<double>(*text);
  }
  if (const auto integer = asExactly<int64_t>(value))
  {
    return static_cast<double>(*integer);
  }
  return asExactly<double>(value);
}

std::optional<std::vector<int64_t>> asGrid(const ParameterValue& value)
{
  std::vector<int64_t> sizes = asExactly<std::vector<int64_t>>(value).value_or(std::vector<int64_t>());
  if (const auto text = asText(value))
  {
    for (size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1)
    {
      end = text->find('x', begin);
      const auto size = parseNumber<int64_t>(text->substr(begin, end - begin));
      if (!size)
      {
        return std::nullopt;
      }
      sizes.push_back(*size);
    }
  }
  return sizes.size() == 3 ? std::optional(sizes) : std::nullopt;
}

std::optional<std::vector<double>> asReals(const ParameterValue& value)
{
  if (const auto* integers = std::get_if<std::vector<int64_t>>(&value))
  {
    return std::vector<double>(integers->begin(), integers->end());
  }
  auto text = asText(value);
  if (!text)
  {
    const auto number = asReal(value);
    return number ? std::optional(std::vector<double>{ *number }) : std::nullopt;
  }
  text->erase(std::remove(text->begin(), text->end(), ' '), text->end());
  if (text->size() >= 2 && text->front() == '[' && text->back() == ']')
  {
    text = text->substr(1, text->size() - 2);
  }
  std::vector<double> numbers;
  for (size_t begin = 0, end = 0; !text->empty() && end != std::string::npos; begin = end + 1)
  {
    end = text->find(',', begin);
    const auto number = parseNumber<double>(text->substr(begin, end - begin));
    if (!number)
    {
      return std::nullopt;
    }
    numbers.push_back(*number);
  }
  return numbers;
}

std::string describe(const ParameterValue& value)
{
  if (const auto* boolean = std::get_if<bool>(&value))
  {
    return *boolean ? "true" : "false";
  }
  if (const auto* integer = std::get_if<int64_t>(&value))
  {
    return toText(*integer);
  }
  if (const auto* real = std::get_if<double>(&value))
  {
    return toText(*real);
  }
  if (const auto* text = std::get_if<std::string>(&value))
  {
    return "\"" + abbreviated(*text) + "\"";
  }
  std::string list;
  for (const int64_t item : std::get<std::vector<int64_t>>(value))
  {
    list += (list.empty() ? "" : ", ") + toText(item);
  }
  return "[" + abbreviated(list) + "]";
}

std::string abbreviated(const std::string& text)
{
  constexpr size_t longest = 80;
  return text.size() <= longest ? text : text.substr(0, longest) + "...";
}
}  // namespace devo_evo
