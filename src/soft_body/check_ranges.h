#pragma once

#include "devo_evo/soft_body/settings.h"
#include "devo_evo/soft_body/text.h"

#include <string>
#include <vector>

namespace devo_evo
{
/// @throw InvalidInput naming the value and where it must lie, also if it is NaN.
template <class Value>
void requireWithin(const std::string& name, Value value, Value low, Value high)
{
  if (!(value >= low && value <= high))
  {
    throw InvalidInput(name + " is " + toText(value) + "; it must lie within " + toText(low) + " to " + toText(high));
  }
}

/// @throw InvalidInput naming the first field that is out of its range (or NaN), its value and its range.
template <class Settings, class Value>
void checkRanges(const Settings& settings, const std::vector<BoundedField<Settings, Value>>& fields)
{
  for (const auto& field : fields)
  {
    requireWithin<Value>(field.name, settings.*field.value, field.minimum, field.maximum);
  }
}
}  // namespace devo_evo
