#include "devo_evo/experiment/parameters.h"

#include <map>

namespace devo_evo
{
namespace
{
constexpr size_t COLUMNS = 120;

/// What each group is about, in the order of the table.
const char* groupTitle(const std::string& group)
{
  static const std::map<std::string, const char*> titles = {
    { "experiment", "Experiment" },
    { "evolution", "Evolution" },
    { "body", "Body and lifetime" },
    { "physics", "Physics" },
    { "rigid body", "Rigid body and its world" },
    { "farm", "Where robots are simulated" },
    { "nodes", "Nodes" },
    { "study", "Studies" },
    { "player", "Player" },
  };
  return titles.at(group);
}

std::string allowedWithUnit(const ParameterSpec& spec)
{
  return spec.allowed + (spec.unit.empty() ? "" : " " + spec.unit);
}

/// A comment of lines that fit, each led by "# ".
std::string wrapped(const std::string& text)
{
  std::string comment, line = "#";
  for (size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1)
  {
    end = text.find(' ', begin);
    const std::string word = text.substr(begin, end - begin);
    if (line.size() + 1 + word.size() > COLUMNS)
    {
      comment += line + "\n";
      line = "#";
    }
    line += " " + word;
  }
  return comment + line + "\n";
}

std::string banner(const std::string& title)
{
  std::string line = "# ---- " + title + " ";
  return line.append(COLUMNS - line.size(), '-') + "\n";
}

std::string yamlDefault(const ParameterSpec& spec)
{
  return spec.default_text.empty() ? "\"\"" : spec.default_text;
}
}  // namespace

std::string parametersAsYaml()
{
  std::string text =
      "# Every parameter of devo_evo at its default. Copy this file, change or remove lines, and hand it over:\n"
      "#   roslaunch devo_evo experiment.launch config:=/path/to/file.yaml\n"
      "#   devo_evo evolve --config file.yaml\n"
      "# Launch arguments and options of the tool go before what stands here. Unknown or repeated keys, values of a "
      "wrong\n"
      "# type and values out of range stop the start. Written by \"devo_evo parameters --yaml\".\n";
  std::string group;
  for (const ParameterSpec& spec : parameterSpecs())
  {
    if (spec.group != group)
    {
      group = spec.group;
      text += "\n" + banner(groupTitle(group));
    }
    text += "\n" + wrapped(spec.description) +
            wrapped("Must be " + allowedWithUnit(spec) + ". Default: " + yamlDefault(spec) + ".");
    text += spec.name + ": " + yamlDefault(spec) + "\n";
  }
  return text;
}

std::string parametersAsYaml(const ExperimentSettings& settings)
{
  Parameters parameters;
  parameters.experiment = settings;
  std::string text;
  for (const ParameterSpec& spec : parameterSpecs())
  {
    if (describesExperiment(spec, settings.body.kind))
    {
      text += spec.name + ": " + spec.get(parameters) + "\n";
    }
  }
  return text;
}

std::string parametersAsMarkdown()
{
  std::string text =
      "# Parameters\n\n"
      "Every parameter has one name: `name: value` in a YAML file, `name:=value` for the launch file (those of the "
      "first "
      "group,\n`grid`, `lifetime`, `population` and `simulators`), `--name value` for the tool. Defaults go before "
      "YAML, "
      "YAML before\nlaunch arguments and options; an empty launch argument means \"as in the YAML\". Unknown or "
      "repeated "
      "keys, values of a\nwrong type and values out of range stop the start with a message that says where and what is "
      "allowed.\n"
      "`config/experiment.yaml` holds all of them at their defaults.\n\n"
      "This page is written by `devo_evo parameters --markdown`.\n";
  std::string group;
  for (const ParameterSpec& spec : parameterSpecs())
  {
    if (spec.group != group)
    {
      group = spec.group;
      text += std::string("\n## ") + groupTitle(group) + "\n\n";
      text += "| Name | Default | Unit | Must be | Meaning |\n|---|---|---|---|---|\n";
    }
    text += "| `" + spec.name + "` | `" + yamlDefault(spec) + "` | " + spec.unit + " | " + spec.allowed + " | " +
            spec.description + " |\n";
  }
  return text;
}
}  // namespace devo_evo
