#pragma once

#include "devo_evo/experiment/parameters.h"

#include "devo_evo/soft_body/text.h"
#include "experiment/parameter_values.h"

#include <algorithm>
#include <functional>
#include <string>
#include <type_traits>

namespace devo_evo
{
// The kinds of parameters that the table is made of.

/// What every parameter has.
struct Heading
{
  std::string name;
  std::string group;
  std::string unit;
  std::string description;
};

/// A parameter of any kind. @param assign sets it if the value is allowed, and tells whether it was.
ParameterSpec makeSpec(const Heading& heading, const std::string& allowed,
                       const std::function<bool(Parameters&, const ParameterValue&)>& assign,
                       const std::function<std::string(const Parameters&)>& get);

/// A real or a whole number, whichever the field holds.
template <class Value>
auto readNumber(const ParameterValue& value)
{
  if constexpr (std::is_same_v<Value, double>)
  {
    return asReal(value);
  }
  else
  {
    return asInteger(value);
  }
}

/// A number with a range. @param section gives the settings that have the field, of given parameters.
template <class Section, class Settings, class Value>
ParameterSpec boundedSpec(Section section, const BoundedField<Settings, Value>& field, const std::string& group,
                          const std::string& unit, const std::string& description)
{
  const auto assign = [section, field](Parameters& parameters, const ParameterValue& value)
  {
    const auto number = readNumber<Value>(value);
    const bool allowed = number && *number >= field.minimum && *number <= field.maximum;
    if (allowed)
    {
      section(parameters).*field.value = static_cast<Value>(*number) + Value(0);  // makes 0.0 of -0.0
    }
    return allowed;
  };
  const auto get = [section, field](const Parameters& parameters) { return toText(section(parameters).*field.value); };
  const std::string kind = std::is_same_v<Value, double> ? "a number" : "a whole number";
  return makeSpec({ field.name, group, unit, description },
                  kind + " within " + toText(field.minimum) + " to " + toText(field.maximum), assign, get);
}

/// The entry of this name among fields that state their own ranges.
template <class Fields>
const auto& fieldNamed(const std::string& name, const Fields& fields)
{
  return *std::find_if(fields.begin(), fields.end(), [&](const auto& field) { return field.name == name; });
}

/// One of a few words. @param parse throws InvalidInput for any other. @param field where it stands, of parameters.
template <class Field, class Parse>
ParameterSpec choiceSpec(const Heading& heading, const std::string& allowed, Field field, Parse parse)
{
  const auto assign = [field, parse](Parameters& parameters, const ParameterValue& value)
  {
    const auto text = asText(value);
    if (!text)
    {
      return false;
    }
    try
    {
      field(parameters) = parse(*text);
    }
    catch (const InvalidInput&)
    {
      return false;
    }
    return true;
  };
  const auto get = [field](const Parameters& parameters) { return toString(field(parameters)); };
  return makeSpec(heading, allowed, assign, get);
}
}  // namespace devo_evo
