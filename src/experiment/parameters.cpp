#include "devo_evo/experiment/parameters.h"

#include "experiment/parameter_values.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace devo_evo
{
namespace
{
/// How many letters must be inserted, removed or replaced to make one word of the other (Levenshtein).
size_t editDistance(const std::string& a, const std::string& b)
{
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (size_t i = 0; i < a.size(); ++i)
  {
    size_t diagonal = row[0];
    row[0] = i + 1;
    for (size_t j = 0; j < b.size(); ++j)
    {
      const size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({ replaced, row[j] + 1, row[j + 1] + 1 });
    }
  }
  return row.back();
}
}  // namespace

bool describesExperiment(const ParameterSpec& spec, BodyKind kind)
{
  static const std::set<std::string> groups = { "experiment", "evolution", "body", "physics", "rigid body" };
  static const std::set<std::string> places = { "founders", "output" };
  return groups.count(spec.group) != 0 && places.count(spec.name) == 0 && (!spec.body || *spec.body == kind);
}

bool describesBody(const ParameterSpec& spec, BodyKind kind)
{
  static const std::set<std::string> groups = { "body", "physics", "rigid body" };
  return groups.count(spec.group) != 0 && (!spec.body || *spec.body == kind);
}

const ParameterSpec& parameterSpec(const std::string& name)
{
  const auto& specs = parameterSpecs();
  const auto spec = std::find_if(specs.begin(), specs.end(), [&](const auto& each) { return each.name == name; });
  if (spec != specs.end())
  {
    return *spec;
  }
  const std::string start = abbreviated(name);
  const auto closest = std::min_element(specs.begin(), specs.end(),
                                        [&](const auto& a, const auto& b)
                                        { return editDistance(start, a.name) < editDistance(start, b.name); });
  throw InvalidInput("there is no parameter \"" + start + "\"; the closest is " + closest->name);
}

void setParameter(Parameters& parameters, const std::string& name, const ParameterValue& value,
                  const std::string& source)
{
  try
  {
    parameterSpec(name).set(parameters, value);
  }
  catch (const InvalidInput& error)
  {
    throw InvalidInput(source + ": " + error.what());
  }
}
}  // namespace devo_evo
