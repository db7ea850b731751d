#include "devo_evo/explanation/explanation.h"

#include "devo_evo/experiment/parameters.h"
#include "explanation/parsing.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace devo_evo
{
namespace
{
std::vector<Explanation> explanationsOfParameters()
{
  std::vector<Explanation> found;
  for (const ParameterSpec& spec : parameterSpecs())
  {
    Explanation explanation = { spec.name, "parameter of " + spec.group + " (docs/parameters.md)", "", {} };
    explanation.facts.emplace_back("Meaning", spec.description);
    if (!spec.unit.empty())
    {
      explanation.facts.emplace_back("Unit", spec.unit);
    }
    explanation.facts.emplace_back("Must be", spec.allowed);
    explanation.facts.emplace_back("Default", spec.default_text.empty() ? "empty" : spec.default_text);
    found.push_back(explanation);
  }
  return found;
}

std::vector<Explanation> allExplanations()
{
  std::vector<Explanation> all;
  for (const Document& document : documents())
  {
    const bool is_page = document.path.rfind("docs/", 0) == 0;
    const auto found = is_page ? explanationsInPage(document) : explanationsInDefinition(document);
    all.insert(all.end(), found.begin(), found.end());
  }
  const auto parameters = explanationsOfParameters();
  all.insert(all.end(), parameters.begin(), parameters.end());
  return all;
}

/// How many letters two words have in common, in order; the longest such sequence.
size_t similarity(const std::string& a, const std::string& b)
{
  std::vector<size_t> row(b.size() + 1, 0);
  for (const char letter : a)
  {
    size_t diagonal = 0;
    for (size_t j = 0; j < b.size(); ++j)
    {
      const size_t above = row[j + 1];
      row[j + 1] = letter == b[j] ? diagonal + 1 : std::max(above, row[j]);
      diagonal = above;
    }
  }
  return row.back();
}

std::string mostSimilar(const std::string& name)
{
  const auto score = [&name](const Explanation& each)
  {
    return 2.0 * static_cast<double>(similarity(name, each.name)) / static_cast<double>(name.size() + each.name.size());
  };
  const auto& all = explanations();
  return std::max_element(all.begin(), all.end(), [&](const auto& a, const auto& b) { return score(a) < score(b); })
      ->name;
}
}  // namespace

const std::vector<Explanation>& explanations()
{
  static const std::vector<Explanation> all = allExplanations();
  return all;
}

std::vector<Explanation> explain(const std::string& name)
{
  std::vector<Explanation> found;
  for (const Explanation& each : explanations())
  {
    if (name == each.name || name == each.owner + "." + each.name)
    {
      found.push_back(each);
    }
  }
  if (found.empty())
  {
    const std::string start = name.substr(0, 80);
    throw InvalidInput("there is nothing called \"" + start + "\"; the most similar is " + mostSimilar(start) +
                       ", and \"devo_evo explain\" lists all names");
  }
  return found;
}
}  // namespace devo_evo
