#include "cli/commands.h"

#include "devo_evo/experiment/build_info.h"
#include "devo_evo/experiment/parameters.h"
#include "devo_evo/soft_body/settings.h"

#include <exception>
#include <iostream>
#include <string>

namespace devo_evo
{
namespace
{
int fail(ExitStatus status, const std::string& message)
{
  std::cout.flush();
  std::cerr << "devo_evo: error: " << message << std::endl;
  return status;
}

/// What is wrong with arguments that no option takes, and what was probably meant.
std::string explainExtras(const CLI::App& tool, const CLI::ExtrasError& error)
{
  for (const std::string& argument : tool.remaining(true))
  {
    if (argument.rfind("--", 0) == 0)
    {
      try
      {
        parameterSpec(argument.substr(2, argument.find('=') - 2));
      }
      catch (const InvalidInput& unknown)
      {
        return argument + ": " + unknown.what();
      }
    }
  }
  return error.what();
}

/// A command that there is not, before anything else is said about the arguments.
void checkCommandName(const CLI::App& tool, const std::string& name)
{
  std::string names;
  for (const CLI::App* app : tool.get_subcommands(nullptr))
  {
    if (app->get_name() == name)
    {
      return;
    }
    names += (names.empty() ? "" : ", ") + app->get_name();
  }
  throw InvalidInput("there is no command \"" + name + "\"; the commands are " + names);
}

int run(int argc, char** argv)
{
  CLI::App tool("Evolves soft robots that develop while they live, without ROS.", "devo_evo");
  tool.set_version_flag("--version", "devo_evo " + versionText());
  tool.require_subcommand(1);
  tool.footer(
      "\"devo_evo COMMAND --help\" says more. Exit status: 0 done, 1 the work failed, 2 wrong usage or input,\n"
      "3 not sound or different, 128 + N ended by signal N. docs/tool.md describes commands and files.");
  Command command;
  addEvaluateCommand(tool, command);
  addEvolveCommand(tool, command);
  addDigestCommand(tool, command);
  addStudyCommand(tool, command);
  addVerifyCommand(tool, command);
  addDiffCommand(tool, command);
  addInfoCommand(tool, command);
  addExportCommand(tool, command);
  addImportCommand(tool, command);
  addExplainCommand(tool, command);
  addManualCommand(tool, command);
  addParametersCommand(tool, command);
  addRenderCommand(tool, command);
  addOverviewCommand(tool, command);
  addGaitMapCommand(tool, command);
  addFiguresCommand(tool, command);
  addReportCommand(tool, command);
  try
  {
    if (argc > 1 && argv[1][0] != '-')
    {
      checkCommandName(tool, argv[1]);
    }
    tool.parse(argc, argv);
    const int status = command();
    std::cout.flush();
    return std::cout ? status : fail(EXIT_WORK_FAILED, "standard output cannot be written");
  }
  catch (const CLI::Success& request)  // --help, --version
  {
    return tool.exit(request);
  }
  catch (const CLI::ExtrasError& error)
  {
    return fail(EXIT_BAD_INPUT, explainExtras(tool, error));
  }
  catch (const CLI::ParseError& error)
  {
    return fail(EXIT_BAD_INPUT, std::string(error.what()) + " (try \"devo_evo --help\")");
  }
  catch (const InvalidInput& error)
  {
    return fail(EXIT_BAD_INPUT, error.what());
  }
  catch (const std::exception& error)
  {
    return fail(EXIT_WORK_FAILED, error.what());
  }
}
}  // namespace
}  // namespace devo_evo

int main(int argc, char** argv)
{
  return devo_evo::run(argc, argv);
}
