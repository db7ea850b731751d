#include "cli/commands.h"

#include "cli/parameter_options.h"
#include "cli/result_stream.h"
#include "devo_evo/experiment/json_lines.h"
#include "devo_evo/interchange/vxa.h"
#include "devo_evo/soft_body/text.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace devo_evo
{
namespace
{
struct ImportArguments
{
  std::vector<std::string> files;
  std::string out = "-";
  std::string parameters;
};

/// Robots, and the body and physics that they are for.
struct Imported
{
  std::vector<std::string> lines;
  std::optional<BodySettings> settings;  ///< of the VXA files; none if there are none
  std::string settings_from;             ///< the file that told of them first
};

std::string readWhole(std::istream& stream, const std::string& name)
{
  constexpr size_t largest = size_t{ 256 } << 20;
  std::string content;
  char part[65536];
  while (stream.read(part, sizeof part), stream.gcount() > 0)
  {
    content.append(part, static_cast<size_t>(stream.gcount()));
    if (content.size() > largest)
    {
      throw InvalidInput(name + ": it has more than " + toText(static_cast<int64_t>(largest)) +
                         " bytes; give the robots in several files");
    }
  }
  return content;
}

/// What there is in the place of a file or pipe; "" if it may be read.
std::string unreadableKind(const std::string& path)
{
  std::error_code ignored;
  switch (std::filesystem::status(path, ignored).type())
  {
    case std::filesystem::file_type::directory:
      return "folder";
    case std::filesystem::file_type::character:
    case std::filesystem::file_type::block:
      return "device";
    default:
      return "";
  }
}

/// @param path of a file or a named pipe; "-" for standard input.
std::string readWhole(const std::string& path)
{
  if (path == "-")
  {
    return readWhole(std::cin, path);
  }
  const std::string kind = unreadableKind(path);
  if (!kind.empty())
  {
    throw InvalidInput(path + ": it is a " + kind + "; a VXA file or JSON lines are needed");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    throw InvalidInput(path + ": it cannot be read: " + std::strerror(errno));
  }
  return readWhole(file, path);
}

Parameters parametersOf(const BodySettings& body)
{
  Parameters parameters;
  parameters.experiment.body = body;
  return parameters;
}

/// "lifetime is 5 in a.vxa and 10 in b", for each parameter of body and physics that differs; empty if none does.
std::string differences(const BodySettings& a, const std::string& where_a, const BodySettings& b,
                        const std::string& where_b)
{
  std::string text;
  for (const ParameterSpec& spec : parameterSpecs())
  {
    const std::string value_a = spec.get(parametersOf(a));
    const std::string value_b = spec.get(parametersOf(b));
    if (value_a != value_b)
    {
      text += (text.empty() ? "" : ", ") + spec.name + " is " + value_a + " in " + where_a + " and " + value_b +
              " in " + where_b;
    }
  }
  return text;
}

void importVxa(Imported& imported, const std::string& content, const std::string& file)
{
  const VxaRobot robot = readVxa(content, file);
  const BodySettings settings(robot.settings);
  if (!imported.settings)
  {
    imported.settings = settings;
    imported.settings_from = file;
  }
  const std::string difference = differences(settings, file, *imported.settings, imported.settings_from);
  if (!difference.empty())
  {
    throw InvalidInput("the robots are for different settings: " + difference + "; import them one by one");
  }
  imported.lines.push_back(robotToJson(robot.id, robot.genome, *makeBody(settings)));
}

void importJson(Imported& imported, const std::string& content, const std::string& file, const BodySettings& settings)
{
  std::istringstream input(content);
  const std::shared_ptr<const Body> body = makeBody(settings);
  RobotReader reader(input, file, *body);
  const size_t before = imported.lines.size();
  while (const auto robot = reader.next())
  {
    imported.lines.push_back(robotToJson(robot->id, robot->genome, *body));
  }
  if (imported.lines.size() == before)
  {
    throw InvalidInput(file + ": there is no robot in it");
  }
}

/// A robot lives another life with other settings: they have to be the same, or be written down.
void checkSettings(const ImportArguments& arguments, const Imported& imported, const BodySettings& ours)
{
  if (!imported.settings || !arguments.parameters.empty())
  {
    return;
  }
  const std::string difference = differences(*imported.settings, imported.settings_from, ours, "ours");
  if (!difference.empty())
  {
    throw InvalidInput("the file has other settings than ours: " + difference +
                       "; give --parameters FILE to have them written for --config, or name ours by options");
  }
}

void writeParameters(const ImportArguments& arguments, const Imported& imported, const BodySettings& ours)
{
  ExperimentSettings settings;
  settings.body = imported.settings.value_or(ours);
  ResultStream file(arguments.parameters, arguments.files);
  file.writeLine("# Body and physics of " + arguments.files.front() + ", by devo_evo import.");
  const Parameters parameters = parametersOf(settings.body);
  for (const ParameterSpec& spec : parameterSpecs())
  {
    if (describesBody(spec, settings.body.kind))
    {
      file.writeLine(spec.name + ": " + spec.get(parameters));
    }
  }
  file.close();
}

int importFiles(const ImportArguments& arguments, const Parameters& parameters)
{
  const BodySettings& ours = parameters.experiment.body;
  parameters.experiment.validateBody();
  Imported imported;
  for (const std::string& file : arguments.files)
  {
    const std::string content = readWhole(file);
    if (looksLikeVxa(content))
    {
      importVxa(imported, content, file);
    }
    else
    {
      importJson(imported, content, file, imported.settings.value_or(ours));
    }
  }
  checkSettings(arguments, imported, ours);
  if (!arguments.parameters.empty())
  {
    writeParameters(arguments, imported, ours);
  }
  std::vector<std::string> others = arguments.files;
  others.push_back(arguments.parameters);
  ResultStream results(arguments.out, others);
  for (const std::string& line : imported.lines)
  {
    results.writeLine(line);
  }
  results.close();
  return EXIT_OK;
}
}  // namespace

void addImportCommand(CLI::App& tool, Command& command)
{
  CLI::App* app = tool.add_subcommand(
      "import", "Turn VXA files, or genomes as JSON lines, into JSON lines that evaluate, player and evolver take.");
  const auto arguments = std::make_shared<ImportArguments>();
  app->add_option("FILE", arguments->files,
                  "VXA files, or files of JSON lines, which is seen from the content; -: standard input")
      ->required();
  app->add_option("--out", arguments->out, "where the robots go instead of standard output")->type_name("FILE");
  app->add_option("--parameters", arguments->parameters,
                  "write body and physics of the VXA files here, for --config of other commands")
      ->type_name("FILE");
  const ParameterOptions options(*app, { "body", "physics", "rigid body" });
  app->footer(
      "Examples:\n"
      "  devo_evo import champion.vxa --out champion.jsonl\n"
      "  devo_evo evolve --founders champion.jsonl --output results/from_champion\n"
      "docs/interchange.md describes the formats.");
  app->callback([=, &command] { command = [=] { return importFiles(*arguments, options.read()); }; });
}
}  // namespace devo_evo
