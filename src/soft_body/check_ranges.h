#pragma once

#include "devo_evo/soft_body/settings.h"
#include "devo_evo/soft_body/text.h"

#include <string>
#include <vector>

namespace devo_evo
{
/// @throw InvalidInput naming the first field that is out of its range (or NaN), its value and its range.
template <class Settings, class Value>
void checkRanges(const Settings& settings, const std::vector<BoundedField<Settings, Value>>& fields)
{
  for (const auto& field : fields)
  {
    const Value value = settings.*field.value;
    if (!(value >= field.minimum && value <= field.maximum))
    {
      throw InvalidInput(std::string(field.name) + " is " + toText(value) + "; it must lie within " +
                         toText(field.minimum) + " to " + toText(field.maximum));
    }
  }
}
}  // namespace devo_evo
