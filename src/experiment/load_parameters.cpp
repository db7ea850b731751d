#include "devo_evo/experiment/parameters.h"

#include "devo_evo/soft_body/text.h"
#include "experiment/parameter_values.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

namespace devo_evo
{
namespace
{
constexpr size_t LARGEST_FILE = size_t{ 1 } << 20;  // [bytes]; one that names every parameter takes less than 1 % of it

std::string readFile(const std::string& path)
{
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
  {
    throw InvalidInput(path + ": it is a folder; a YAML file is needed");
  }
  std::ifstream file(path, std::ios::binary);
  std::string content(LARGEST_FILE + 1, '\0');
  file.read(content.data(), static_cast<std::streamsize>(content.size()));
  if (file.bad() || !file.is_open())
  {
    throw InvalidInput(path + ": it cannot be read: " + std::strerror(errno));
  }
  content.resize(static_cast<size_t>(file.gcount()));
  if (content.size() > LARGEST_FILE)
  {
    throw InvalidInput(path + ": it has more than " + toText(static_cast<int64_t>(LARGEST_FILE)) +
                       " bytes; a file of parameters needs far less");
  }
  return content;
}

/// "experiment.yaml:12"
std::string position(const std::string& file, const YAML::Mark& mark)
{
  return mark.is_null() ? file : file + ":" + toText(mark.line + 1);
}

/// Notes where documents begin, and lets pass what is in them.
class DocumentStarts : public YAML::EventHandler
{
public:
  void OnDocumentStart(const YAML::Mark& mark) override { latest = mark; }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}

  YAML::Mark latest;
};

/// Where a second document begins, if there is one. YAML::LoadAll() would tell, but never ends where a document cannot
/// begin, as with a comma: it takes that for one empty document after another.
std::optional<YAML::Mark> secondDocument(const std::string& text)
{
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  DocumentStarts starts;
  if (!parser.HandleNextDocument(starts))
  {
    return std::nullopt;
  }
  const YAML::Mark first = starts.latest;
  if (!parser.HandleNextDocument(starts))
  {
    return std::nullopt;
  }
  if (starts.latest.pos == first.pos)
  {
    throw YAML::ParserException(first, "a document cannot begin like this");
  }
  return starts.latest;
}

/// The only document of a YAML file; a null node if there is none.
YAML::Node loadDocument(const std::string& path)
{
  const std::string text = readFile(path);
  try
  {
    if (const auto second = secondDocument(text))
    {
      throw InvalidInput(position(path, *second) + ": a second document; a file must have only one");
    }
    return YAML::Load(text);
  }
  catch (const YAML::Exception& error)
  {
    throw InvalidInput(position(path, error.mark) + ": malformed YAML: " + error.msg);
  }
}

/// A list of whole numbers; as text, which no parameter takes, if it is another list.
ParameterValue listValue(const YAML::Node& node)
{
  std::vector<int64_t> numbers;
  for (const YAML::Node& item : node)
  {
    const auto number = item.IsScalar() ? asInteger(item.Scalar()) : std::nullopt;
    if (!number)
    {
      return YAML::Dump(node);
    }
    numbers.push_back(*number);
  }
  return numbers;
}

void setParameter(Parameters& parameters, const ParameterSpec& spec, const YAML::Node& node)
{
  if (node.IsNull() || node.IsMap())
  {
    throw InvalidInput(spec.name + (node.IsMap() ? " is a map" : " has no value") + "; it must be " + spec.allowed);
  }
  spec.set(parameters, node.IsScalar() ? ParameterValue(node.Scalar()) : listValue(node));
}
}  // namespace

void loadParameters(Parameters& parameters, const std::string& yaml_file)
{
  const YAML::Node document = loadDocument(yaml_file);
  if (document.IsNull())
  {
    return;
  }
  if (!document.IsMap())
  {
    throw InvalidInput(position(yaml_file, document.Mark()) + ": the file must hold lines of the form \"name: value\"");
  }
  std::map<std::string, std::string> seen;
  for (const auto& entry : document)
  {
    const std::string source = position(yaml_file, entry.first.Mark());
    const std::string name = entry.first.IsScalar() ? entry.first.Scalar() : YAML::Dump(entry.first);
    const auto [earlier, is_new] = seen.emplace(name, source);
    if (!is_new)
    {
      throw InvalidInput(source + ": " + name + " is given twice, first in " + earlier->second);
    }
    try
    {
      setParameter(parameters, parameterSpec(name), entry.second);
    }
    catch (const InvalidInput& error)
    {
      throw InvalidInput(source + ": " + error.what());
    }
  }
}
}  // namespace devo_evo
