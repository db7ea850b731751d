#include "cli/commands.h"

#include "cli/interruption.h"
#include "cli/parameter_options.h"
#include "cli/progress_display.h"
#include "devo_evo/experiment/build_info.h"
#include "devo_evo/experiment/scale.h"
#include "devo_evo/farm/local_farm.h"
#include "devo_evo/study/study.h"

#include <iostream>

namespace devo_evo
{
namespace
{
/// Shows progress on the terminal; a signal stops the study.
class TerminalStudyObserver : public StudyObserver
{
public:
  void say(const std::string& line) override
  {
    display_.end();
    std::cerr << "devo_evo: " << line << std::endl;
  }
  void showProgress(const std::string& line) override { display_.show(line, false); }
  bool stopRequested() override { return interruption() != 0; }
  void end() { display_.end(); }

private:
  ProgressDisplay display_;
};

int study(Parameters parameters, bool only_estimate)
{
  std::string& output = parameters.experiment.output;
  output = output.empty() ? defaultStudyOutput(parameters) : absoluteFolder(output);
  validateStudy(parameters);
  const InstructionSet instruction_set = parseInstructionSet(parameters.instruction_set);
  const int threads = threadCount(parameters);
  const std::string estimate = estimateText(parameters, threads, instruction_set);
  if (only_estimate)
  {
    std::cout << estimate << "\n";
    return EXIT_OK;
  }
  TerminalStudyObserver observer;
  observer.say("study of scale " + toString(parameters.study.scale) + " in " + output + "\n" + estimate);
  noteInterruptions();
  const auto make_farm = [&](const BodySettings& body)
  { return makeLocalFarm(makeBody(body), threads, instruction_set); };
  const RunOutcome outcome =
      runStudy(parameters, localProvenance(toString(instruction_set), *makeBody(parameters.experiment.body)), make_farm,
               observer);
  observer.end();
  if (outcome == RunOutcome::STOPPED)
  {
    std::cerr << "devo_evo: stopped by " << signalName(interruption()) << "; the same command goes on where it was\n";
    return 128 + interruption();
  }
  std::cout << "Study: " << output << "\n";
  return EXIT_OK;
}
}  // namespace

void addStudyCommand(CLI::App& tool, Command& command)
{
  CLI::App* app =
      tool.add_subcommand("study", "Run the experiments of the paper and its analyses, or go on with them.");
  const ParameterOptions options(*app, { "study", "experiment", "evolution", "body", "physics", "rigid body", "farm" });
  auto only_estimate = std::make_shared<bool>(false);
  app->add_flag("--estimate", *only_estimate, "Only say how much is left to simulate, and how long that takes here");
  app->footer(
      "Examples:\n"
      "  devo_evo study                                    everything in a few minutes, much too small\n"
      "  devo_evo study --scale paper --estimate           how long the paper's own study would take\n"
      "  devo_evo study --scale overnight --profile released_code --output /data/study\n"
      "  devo_evo study --only main,walks --trials 10 --walk_steps 200\n"
      "Numbers that are not given are as the scale says (docs/study.md). Ctrl-C stops it; the same command resumes "
      "it.");
  app->callback(
      [=, &command] {
        command = [=] { return study(options.read(parametersAtScale(options.read().study.scale)), *only_estimate); };
      });
}
}  // namespace devo_evo
