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
  std::vector<double> slopes = { 1.0, 2.0, 2.5, 3.0, 3.5, 4.0 };                  // [degrees]
  std::vector<double> residuals = { 0.0, 0.02, 0.03, 0.035, 0.04, 0.045, 0.05 };  // [m]
  GaitSearch search;
};

/// Shows progress on the terminal; a signal stops the map.
class TerminalMapObserver : public GaitMapObserver
{
public:
  explicit TerminalMapObserver(size_t worlds) : worlds_(static_cast<int64_t>(worlds)) {}

  void cellDone(const GaitMapCell& cell) override
  {
    ++done_;
    display_.show(toText(done_) + " of " + toText(worlds_) + " worlds: slope " + toText(cell.world.slope) +
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

/// Those of a file that do not develop: the others would be given away what a search has to find.
std::vector<QuadrupedProgram> readConstantQuadrupeds(const std::string& path, const RigidBodySettings& world)
{
  const std::shared_ptr<const Body> body = makeRigidBody(world);
  RobotSource source(path);
  source.check(*body);
  RobotReader reader = source.read(*body);
  std::vector<QuadrupedProgram> quadrupeds;
  while (const auto robot = reader.next())
  {
    const DevelopmentalProgram& program = robot->genome.program;
    if (program.morphology_initial == program.morphology_final && program.control_initial == program.control_final)
    {
      quadrupeds.push_back(toQuadruped(program));
    }
  }
  return quadrupeds;
}

std::string columnsOf(const QuadrupedEvaluation& life)
{
  return life.valid ? "," + toText(life.fitness) + "," + toText(life.descent) + "," + toText(life.turns) : ",,,";
}

std::string columnsOf(const std::optional<LivedQuadruped>& robot)
{
  return robot ? columnsOf(robot->evaluation) : ",,,";
}

std::string columnsOf(const PaperObservations& seen)
{
  std::string columns;
  for (const bool holds : { seen.walks, seen.rolls_better, seen.protruding_hinders, seen.drawing_in_rolls })
  {
    columns += holds ? ",1" : ",0";
  }
  return columns;
}

void writeMap(const std::vector<GaitMapCell>& cells, ResultStream& results)
{
  std::string header = "slope,leg_residual,evaluations";
  for (const std::string robot : { "walking", "rolling", "passive", "smooth", "drawing_in" })
  {
    header += "," + robot + "_fitness," + robot + "_descent," + robot + "_turns";
  }
  header += ",drawing_in_first_roll,drawing_in_last_velocity";
  results.writeLine(header + ",walks,rolls_better,protruding_hinders,drawing_in_rolls");
  for (const GaitMapCell& cell : cells)
  {
    const QuadrupedEvaluation& drawing_in = cell.drawing_in.evaluation;
    results.writeLine(toText(cell.world.slope) + "," + toText(cell.world.leg_residual) + "," +
                      toText(cell.evaluations) + columnsOf(cell.walking) + columnsOf(cell.rolling) +
                      columnsOf(cell.passive) + columnsOf(cell.smooth) + columnsOf(drawing_in) + "," +
                      (drawing_in.first_roll_s ? toText(*drawing_in.first_roll_s) : "") + "," +
                      (drawing_in.valid ? toText(drawing_in.velocity.back()) : "") + columnsOf(observe(cell)));
  }
}

int mapGaits(GaitMapArguments arguments, const Parameters& parameters)
{
  const RigidBodySettings& world = parameters.experiment.body.rigid;
  arguments.search.known = readConstantQuadrupeds(arguments.robots, world);
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
  app->add_option("FILE", arguments->robots,
                  "quadrupeds, one JSON object a line; every search begins with those that do not develop")
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
