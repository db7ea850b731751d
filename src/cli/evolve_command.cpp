#include "cli/commands.h"

#include "cli/interruption.h"
#include "cli/parameter_options.h"
#include "cli/progress_display.h"
#include "devo_evo/experiment/build_info.h"
#include "devo_evo/experiment/experiment.h"
#include "devo_evo/experiment/report_text.h"
#include "devo_evo/farm/local_farm.h"

#include <filesystem>
#include <iostream>
#include <string>

namespace devo_evo
{
namespace
{
/// Shows progress, and stops the experiment when a signal came.
class TerminalObserver : public ExperimentObserver
{
public:
  explicit TerminalObserver(const ExperimentSettings& settings) : settings_(settings) {}

  void watch(Experiment& experiment) { experiment_ = &experiment; }

  void generationCommitted(const GenerationReport& report) override
  {
    const bool last = report.record.generation == settings_.generations;
    display_.show(progressText(report, settings_), last);
  }

  void tick() override
  {
    if (interruption() != 0)
    {
      experiment_->stopNow();
    }
  }

  ProgressDisplay& display() { return display_; }

private:
  const ExperimentSettings settings_;
  ProgressDisplay display_;
  Experiment* experiment_ = nullptr;
};

int evolve(const Parameters& parameters)
{
  ExperimentSettings settings = parameters.experiment;
  settings.output = settings.output.empty() ? defaultOutput(settings) : absoluteFolder(settings.output);
  if (!settings.founders.empty())
  {
    settings.founders = std::filesystem::absolute(settings.founders).lexically_normal().string();
  }
  loadFounders(settings);
  settings.validate();
  const InstructionSet instruction_set = parseInstructionSet(parameters.instruction_set);
  const std::shared_ptr<const Body> body = makeBody(settings.body);
  const auto archive = openArchiveForWriting(settings, localProvenance(toString(instruction_set), *body));
  std::cerr << "devo_evo: evolving in " << settings.output << (archive->trials().empty() ? "" : ", resumed") << "\n";
  const auto farm = makeLocalFarm(body, threadCount(parameters), instruction_set);
  TerminalObserver observer(settings);
  Experiment experiment(settings, *archive, *farm, observer);
  observer.watch(experiment);
  noteInterruptions();
  const RunOutcome outcome = experiment.run();

  observer.display().end();
  std::cout << resultsText(*archive, settings.output);
  if (outcome == RunOutcome::STOPPED)
  {
    std::cerr << "devo_evo: stopped by " << signalName(interruption())
              << "; the same command goes on from the last finished generation\n";
    return 128 + interruption();
  }
  std::cout << "To go on: the same command with more --generations or --trials\n";
  return EXIT_OK;
}
}  // namespace

void addEvolveCommand(CLI::App& tool, Command& command)
{
  CLI::App* app = tool.add_subcommand("evolve", "Run an experiment on threads of this process, or resume one.");
  const ParameterOptions options(*app, { "experiment", "evolution", "body", "physics", "rigid body", "farm" });
  app->footer(
      "Examples:\n"
      "  devo_evo evolve                                   the paper's Evo-Devo, one trial of 20 generations\n"
      "  devo_evo evolve --treatment evo --trials 30 --generations 10000 --output /data/evo\n"
      "  devo_evo evolve --config experiment.yaml --seed 2\n"
      "  devo_evo evolve --body rigid --generations 200    the quadruped of Fig S5\n"
      "Ctrl-C stops it; the same command resumes it where it was.\n"
      "\"devo_evo parameters\" tells the range of each parameter.");
  app->callback([=, &command] { command = [=] { return evolve(options.read()); }; });
}
}  // namespace devo_evo
