#include "cli/commands.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace devo_evo
{
namespace
{
// Where another python3 stands first on the path, it lacks the packages.
const char* const PYTHON = "/usr/bin/python3";

/// What the analysis commands have in common; they run in Python (src/devo_evo).
struct AnalysisArguments
{
  std::string output;
  std::string into;
  std::vector<std::string> only;
};

std::filesystem::path programPath()
{
  return std::filesystem::canonical("/proc/self/exe");
}

/// The folder that holds the Python module: beside the program where it is installed, else that of the sources.
std::string moduleFolder()
{
  const std::filesystem::path program = programPath();
  const std::vector<std::filesystem::path> candidates = {
    program.parent_path() / "../../" PYTHON_MODULE_DESTINATION,  // from <prefix>/lib/devo_evo
    program.parent_path() / "../" PYTHON_MODULE_DESTINATION,     // from <prefix>/bin
    PYTHON_MODULE_SOURCE,
  };
  std::string tried;
  for (const std::filesystem::path& candidate : candidates)
  {
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::weakly_canonical(candidate, error);
    if (std::filesystem::exists(folder / "devo_evo" / "report.py", error))
    {
      return folder.string();
    }
    tried += (tried.empty() ? "" : ", ") + folder.string();
  }
  throw std::runtime_error("the Python module devo_evo is missing; it was looked for in " + tried);
}

/// Becomes Python; its exit status and signals are ours.
[[noreturn]] void runModule(std::vector<std::string> words)
{
  const char* const inherited = std::getenv("PYTHONPATH");
  const std::string path = moduleFolder() + (inherited && *inherited ? std::string(":") + inherited : "");
  setenv("PYTHONPATH", path.c_str(), 1);
  setenv("DEVO_EVO_TOOL", programPath().c_str(), 1);
  words.insert(words.begin(), { PYTHON, "-m", "devo_evo" });
  std::vector<char*> arguments;
  for (std::string& word : words)
  {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  execv(PYTHON, arguments.data());
  throw std::runtime_error(std::string(PYTHON) + " cannot be run: " + std::strerror(errno) +
                           "; install the packages of the group \"Analysis\" of packages.txt");
}

std::vector<std::string> wordsOf(const std::string& name, const AnalysisArguments& arguments)
{
  std::vector<std::string> words = { name };
  if (!arguments.into.empty())
  {
    words.push_back("--into=" + arguments.into);
  }
  for (const std::string& figure : arguments.only)
  {
    words.push_back("--only=" + figure);
  }
  words.insert(words.end(), { "--", arguments.output });
  return words;
}

CLI::App* addAnalysisCommand(CLI::App& tool, Command& command, const std::string& name, const std::string& description,
                             const std::shared_ptr<AnalysisArguments>& arguments)
{
  CLI::App* app = tool.add_subcommand(name, description);
  app->add_option("OUTPUT", arguments->output, "the folder that a study or an experiment wrote to")->required();
  app->add_option("--into", arguments->into, "where to write, instead of OUTPUT/" + name)->type_name("FOLDER");
  app->callback([=, &command] { command = [=]() -> int { runModule(wordsOf(name, *arguments)); }; });
  return app;
}
}  // namespace

void addFiguresCommand(CLI::App& tool, Command& command)
{
  const auto arguments = std::make_shared<AnalysisArguments>();
  CLI::App* app = addAnalysisCommand(tool, command, "figures",
                                     "Draw the paper's figures from a study: PDF, PNG and CSV.", arguments);
  app->add_option("--only", arguments->only, "a figure to draw, such as 3 or S1; may come several times")
      ->type_name("FIGURE");
}

void addReportCommand(CLI::App& tool, Command& command)
{
  addAnalysisCommand(tool, command, "report", "Test every claim of the paper on a study: report.html and report.md.",
                     std::make_shared<AnalysisArguments>());
}
}  // namespace devo_evo
