#include "cli/commands.h"

#include "devo_evo/soft_body/settings.h"

#include <exception>
#include <iostream>

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

int run(int argc, char** argv)
{
  CLI::App tool("Evolves soft robots that develop while they live, without ROS.", "devo_evo");
  tool.require_subcommand(1);
  Command command;
  addParametersCommand(tool, command);
  try
  {
    tool.parse(argc, argv);
    const int status = command();
    std::cout.flush();
    return std::cout ? status : fail(EXIT_WORK_FAILED, "standard output cannot be written");
  }
  catch (const CLI::Success& request)  // --help, --version
  {
    return tool.exit(request);
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
