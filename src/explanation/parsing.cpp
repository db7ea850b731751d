#include "explanation/parsing.h"

#include <sstream>

namespace devo_evo
{
namespace
{
std::string trimmed(const std::string& text)
{
  const size_t begin = text.find_first_not_of(" \t\r");
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

/// "| a | b |" has the cells "a" and "b"; none if it is no row of a table.
std::vector<std::string> cellsOf(const std::string& line)
{
  std::vector<std::string> cells;
  if (line.empty() || line.front() != '|')
  {
    return cells;
  }
  for (size_t begin = 1; begin < line.size();)
  {
    const size_t end = line.find('|', begin);
    if (end == std::string::npos)
    {
      break;
    }
    cells.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return cells;
}

/// What stands in code style: "`a`, `b`" names a and b.
std::vector<std::string> namesIn(const std::string& cell)
{
  std::vector<std::string> names;
  for (size_t begin = cell.find('`'); begin != std::string::npos;)
  {
    const size_t end = cell.find('`', begin + 1);
    if (end == std::string::npos)
    {
      break;
    }
    names.push_back(cell.substr(begin + 1, end - begin - 1));
    begin = cell.find('`', end + 1);
  }
  return names;
}

std::string capitalised(std::string text)
{
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z')
  {
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  }
  return text;
}

/// The headings of those tables that explain names, by what stands over their first column.
bool explainsNames(const std::vector<std::string>& header)
{
  return !header.empty() && (header[0] == "column" || header[0] == "Field" || header[0] == "Measure");
}

std::string baseName(const std::string& path)
{
  const size_t begin = path.rfind('/') + 1;
  return path.substr(begin, path.rfind('.') - begin);
}
}  // namespace

std::vector<Explanation> explanationsInPage(const Document& page)
{
  std::vector<Explanation> found;
  std::vector<std::string> header;
  std::string heading;
  std::istringstream lines(page.content);
  for (std::string line; std::getline(lines, line);)
  {
    const std::vector<std::string> cells = cellsOf(line);
    if (cells.empty())
    {
      header.clear();
      heading = line.rfind("#", 0) == 0 ? trimmed(line.substr(line.find_first_not_of('#'))) : heading;
      continue;
    }
    if (header.empty())
    {
      header = cells;
      continue;
    }
    if (!explainsNames(header))
    {
      continue;
    }
    for (const std::string& name : namesIn(cells[0]))
    {
      const bool is_measure = header[0] == "Measure";
      Explanation explanation = {
        name, (is_measure ? "measure" : heading) + " (" + page.path + ")", is_measure ? "" : heading, {}
      };
      for (size_t i = 1; i < cells.size() && i < header.size(); ++i)
      {
        if (!cells[i].empty())
        {
          explanation.facts.emplace_back(header[i].empty() ? "If missing" : capitalised(header[i]), cells[i]);
        }
      }
      found.push_back(explanation);
    }
  }
  return found;
}

std::vector<Explanation> explanationsInDefinition(const Document& definition)
{
  std::vector<Explanation> found;
  const std::string owner = baseName(definition.path);
  std::string comment;
  std::istringstream lines(definition.content);
  for (std::string line; std::getline(lines, line);)
  {
    line = trimmed(line);
    if (line.empty() || line == "---")
    {
      comment.clear();
      continue;
    }
    if (line.front() == '#')
    {
      comment += (comment.empty() ? "" : " ") + trimmed(line.substr(1));
      continue;
    }
    std::istringstream words(line);
    std::string type, name;
    words >> type >> name;
    Explanation explanation = { name, "field of " + owner + " (" + definition.path + ")", owner, {} };
    explanation.facts.emplace_back("Meaning", comment);
    explanation.facts.emplace_back("Type", type);
    const size_t equals = line.find('=');
    if (equals != std::string::npos)
    {
      explanation.facts.emplace_back("Value", trimmed(line.substr(equals + 1)));
    }
    found.push_back(explanation);
  }
  return found;
}
}  // namespace devo_evo
