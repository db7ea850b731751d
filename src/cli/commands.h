#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace devo_evo
{
/// Exit statuses of the tool (docs/tool.md). A run that a signal ended has 128 + the signal's number.
enum ExitStatus
{
  EXIT_OK = 0,
  EXIT_WORK_FAILED = 1,
  EXIT_BAD_INPUT = 2,
  EXIT_DIFFERENCE = 3  ///< the work is done, and the answer is no: something is not sound, two things differ
};

/// What the command line asks for: set by the subcommand that was chosen, run after parsing. @return the exit status.
using Command = std::function<int()>;

// Each adds a subcommand to the tool. `command` must outlive the parsing.
void addEvaluateCommand(CLI::App& tool, Command& command);
void addEvolveCommand(CLI::App& tool, Command& command);
void addDigestCommand(CLI::App& tool, Command& command);
void addStudyCommand(CLI::App& tool, Command& command);
void addVerifyCommand(CLI::App& tool, Command& command);
void addDiffCommand(CLI::App& tool, Command& command);
void addInfoCommand(CLI::App& tool, Command& command);
void addExportCommand(CLI::App& tool, Command& command);
void addImportCommand(CLI::App& tool, Command& command);
void addExplainCommand(CLI::App& tool, Command& command);
void addManualCommand(CLI::App& tool, Command& command);
void addParametersCommand(CLI::App& tool, Command& command);
void addRenderCommand(CLI::App& tool, Command& command);
void addOverviewCommand(CLI::App& tool, Command& command);
void addGaitMapCommand(CLI::App& tool, Command& command);
void addFiguresCommand(CLI::App& tool, Command& command);
void addReportCommand(CLI::App& tool, Command& command);
}  // namespace devo_evo
