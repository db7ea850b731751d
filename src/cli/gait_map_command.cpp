#include "cli/commands.h"

#include "cli/interruption.h"
#include "cli/parameter_options.h"
#include "cli/progress_display.h"
#include "cli/result_stream.h"
#include "cli/robot_source.h"
#include "devo_evo/bodies/rigid.h"
#include "devo_evo/soft_body/simulation.h"
#include "devo_evo/soft_body/text.h"
#include "devo_evo/study/gait_map.h"

#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace devo_evo
{
namespace
{
struct GaitMapArguments
{
  std::string robots;
  std::string output = "-";
  std::vector<double> slopes = { 0.0, 1.0, 2.0, 3.0, 4.0, 6.0 };               // [degrees]
  std::vector<double> residuals = { 0.0, 0.03, 0.04, 0.05, 0.06, 0.08, 0.1 };  // [m]
  GaitSearch search;
};

/// Shows progress on the terminal; a signal stops the map.
class TerminalMapObserver : public GaitMapObserver
{
public:
  explicit TerminalMapObserver(size_t worlds) : worlds_(static_cast<int64_t>(worlds)) {}

  void cellDone(const GaitMapCell& cell) override
  {
    display_.show(toText(++done_) + " of " + toText(worlds_) + " worlds: slope " + toText(cell.world.slope) +
                      " degrees, residual " + toText(cell.world.leg_residual) + " m",
                  done_ == worlds_);
  }
  bool stopRequested() override { return interruption() != 0; }
  void end() { display_.end(); }

private:
  ProgressDisplay display_;
  const int64_t worlds_;
  int64_t done_ = 0;
};

std::vector<QuadrupedProgram> readQuadrupeds(const std::string& path, const RigidBodySettings& world)
{
  const std::shared_ptr<const Body> body = makeRigidBody(world);
  RobotSource source(path);
  source.check(*body);
  RobotReader reader = source.read(*body);
  std::vector<QuadrupedProgram> quadrupeds;
  while (const auto robot = reader.next())
  {
    quadrupeds.push_back(toQuadruped(robot->genome.program));
  }
  return quadrupeds;
}

std::string columnsOf(const std::optional<LivedQuadruped>& robot)
{
  if (!robot)
  {
    return ",,,";
  }
  const QuadrupedEvaluation& life = robot->evaluation;
  return "," + toText(life.fitness) + "," + toText(life.descent) + "," + toText(life.turns);
}

void writeMap(const std::vector<GaitMapCell>& cells, ResultStream& results)
{
  results.writeLine(
      "slope,leg_residual,evaluations,walking_fitness,walking_descent,walking_turns,rolling_fitness,rolling_descent,"
      "rolling_turns");
  for (const GaitMapCell& cell : cells)
  {
    results.writeLine(toText(cell.world.slope) + "," + toText(cell.world.leg_residual) + "," +
                      toText(cell.evaluations) + columnsOf(cell.walking) + columnsOf(cell.rolling));
  }
}

int mapGaits(GaitMapArguments arguments, const Parameters& parameters)
{
  const RigidBodySettings& world = parameters.experiment.body.rigid;
  arguments.search.known = readQuadrupeds(arguments.robots, world);
  arguments.search.seed = parameters.experiment.evolution.seed;
  noteInterruptions();
  ResultStream results(arguments.output, { arguments.robots });
  TerminalMapObserver observer(arguments.slopes.size() * arguments.residuals.size());
  try
  {
    writeMap(
        mapGaits(world, arguments.slopes, arguments.residuals, arguments.search, threadCount(parameters), observer),
        results);
  }
  catch (const EvaluationAbandoned&)
  {
    observer.end();
    std::cerr << "devo_evo: stopped by " << signalName(interruption()) << "; there is no map\n";
    return 128 + interruption();
  }
  observer.end();
  results.close();
  return EXIT_OK;
}
}  // namespace

void addGaitMapCommand(CLI::App& tool, Command& command)
{
  CLI::App* app = tool.add_subcommand(
      "gait_map", "Which gait takes rigid quadrupeds closer to the light, world by world (docs/rigid_body.md).");
  const auto arguments = std::make_shared<GaitMapArguments>();
  app->add_option("FILE", arguments->robots, "quadrupeds that every search begins with, one JSON object a line")
      ->required();
  app->add_option("--out", arguments->output, "CSV file instead of standard output")->type_name("FILE");
  app->add_option("--slopes", arguments->slopes, "of the floor [degrees]")->delimiter(',')->capture_default_str();
  app->add_option("--residuals", arguments->residuals, "how far legs drawn in protrude [m]")
      ->delimiter(',')
      ->capture_default_str();
  app->add_option("--random", arguments->search.random_robots, "robots made at random, that a search begins with too")
      ->capture_default_str();
  app->add_option("--steps", arguments->search.climbing_steps, "of a hill climb for each gait")->capture_default_str();
  const ParameterOptions options(*app, { "rigid body", "experiment", "farm" });
  app->footer(
      "Example:\n  devo_evo gait_map config/quadrupeds.jsonl --slopes 1,2,3 --residuals 0,0.04,0.08 --out map.csv\n"
      "rigid_slope and rigid_leg_residual of the parameters do not count here.");
  app->callback([=, &command] { command = [=] { return mapGaits(*arguments, options.read()); }; });
}
}  // namespace devo_evo
