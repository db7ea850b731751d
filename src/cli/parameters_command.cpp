#include "cli/commands.h"

#include "devo_evo/experiment/parameters.h"

#include <iostream>
#include <memory>

namespace devo_evo
{
namespace
{
/// For a quick look: name, default and what is allowed.
std::string parametersAsText()
{
  std::string text;
  for (const ParameterSpec& spec : parameterSpecs())
  {
    text += spec.name + ": " + (spec.default_text.empty() ? "\"\"" : spec.default_text) + "\n    " + spec.description +
            "\n    Must be " + spec.allowed + (spec.unit.empty() ? "" : " " + spec.unit) + ".\n";
  }
  return text;
}
}  // namespace

void addParametersCommand(CLI::App& tool, Command& command)
{
  CLI::App* app = tool.add_subcommand("parameters", "List every parameter: meaning, default, unit, range.");
  const auto yaml = std::make_shared<bool>(false);
  const auto markdown = std::make_shared<bool>(false);
  CLI::Option* yaml_flag = app->add_flag("--yaml", *yaml, "as a file for --config");
  app->add_flag("--markdown", *markdown, "as a page of documentation")->excludes(yaml_flag);
  app->callback(
      [=, &command]
      {
        command = [=]
        {
          std::cout << (*yaml ? parametersAsYaml() : *markdown ? parametersAsMarkdown() : parametersAsText());
          return EXIT_OK;
        };
      });
}
}  // namespace devo_evo
