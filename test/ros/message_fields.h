#pragma once

#include <devo_evo/EvaluationSettings.h>
#include <devo_evo/NamedNumber.h>
#include <devo_evo/RobotGenome.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace devo_evo::test
{
/// The element of this name. @throw std::out_of_range if there is none.
template <class Named>
Named& elementNamed(std::vector<Named>& elements, const std::string& name)
{
  for (Named& element : elements)
  {
    if (element.name == name)
    {
      return element;
    }
  }
  throw std::out_of_range(name);
}

/// The values of one of a genome's arrays.
inline std::vector<double>& valuesOf(RobotGenome& message, const std::string& name)
{
  return elementNamed(message.arrays, name).values;
}

inline double& valueOf(std::vector<NamedNumber>& numbers, const std::string& name)
{
  return elementNamed(numbers, name).value;
}

inline void setValue(EvaluationSettings& message, const std::string& name, const std::string& value)
{
  for (size_t i = 0; i < message.names.size(); ++i)
  {
    if (message.names[i] == name)
    {
      message.values[i] = value;
      return;
    }
  }
  throw std::out_of_range(name);
}
}  // namespace devo_evo::test
