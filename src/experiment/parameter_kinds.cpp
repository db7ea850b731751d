#include "experiment/parameter_kinds.h"

namespace devo_evo
{
ParameterSpec makeSpec(const Heading& heading, const std::string& allowed,
                       const std::function<bool(Parameters&, const ParameterValue&)>& assign,
                       const std::function<std::string(const Parameters&)>& get)
{
  ParameterSpec spec;
  spec.name = heading.name;
  spec.group = heading.group;
  spec.unit = heading.unit;
  spec.description = heading.description;
  spec.allowed = allowed;
  spec.default_text = get(Parameters());
  spec.set = [heading, allowed, assign](Parameters& parameters, const ParameterValue& value)
  {
    if (!assign(parameters, value))
    {
      throw InvalidInput(heading.name + " is " + describe(value) + "; it must be " + allowed +
                         (heading.unit.empty() ? "" : " " + heading.unit));
    }
  };
  spec.get = get;
  return spec;
}
}  // namespace devo_evo
