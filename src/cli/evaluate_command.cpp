#include "cli/commands.h"

#include "cli/interruption.h"
#include "cli/parameter_options.h"
#include "cli/result_stream.h"
#include "cli/robot_source.h"
#include "devo_evo/farm/local_farm.h"
#include "devo_evo/soft_body/text.h"

#include <deque>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace devo_evo
{
namespace
{
struct EvaluateArguments
{
  std::string input;
  std::string output = "-";
};

/// Hands robots to a farm and writes their evaluations in the order of the robots.
class OrderedEvaluation
{
public:
  /// @param window how many robots may be under way: bounds the memory, and keeps the farm busy.
  OrderedEvaluation(RobotReader& robots, Farm& farm, const Body& body, ResultStream& results, size_t window)
    : robots_(robots), farm_(farm), body_(body), results_(results), window_(window)
  {
  }

  /// @return whether it came to the end; false if a signal came before.
  bool run()
  {
    submit();
    while (!ids_.empty())
    {
      if (interruption() != 0)
      {
        return false;
      }
      for (EvaluationResult& result : farm_.collect(std::chrono::milliseconds(100)))
      {
        evaluations_.emplace(result.id, std::move(result.evaluation));
      }
      write();
      submit();
    }
    return true;
  }

private:
  void submit()
  {
    std::vector<EvaluationRequest> requests;
    while (!at_end_ && ids_.size() < window_)
    {
      auto robot = robots_.next();
      if (!robot)
      {
        at_end_ = true;
        break;
      }
      const auto number = first_ + static_cast<int64_t>(ids_.size());
      ids_.push_back(std::move(robot->id));
      requests.push_back({ 0, number, std::move(robot->genome.program) });
    }
    farm_.submit(std::move(requests));
  }

  void write()
  {
    for (auto next = evaluations_.find(first_); next != evaluations_.end(); next = evaluations_.find(first_))
    {
      results_.writeLine(evaluationToJson(ids_.front(), next->second, body_));
      evaluations_.erase(next);
      ids_.pop_front();
      ++first_;
    }
    results_.flush();
  }

  RobotReader& robots_;
  Farm& farm_;
  const Body& body_;
  ResultStream& results_;
  const size_t window_;
  bool at_end_ = false;
  int64_t first_ = 0;                          ///< number of the first robot whose evaluation is not written
  std::deque<RobotId> ids_;                    ///< of the robots under way, from first_ on
  std::map<int64_t, Evaluation> evaluations_;  ///< that wait for those before them, by number of the robot
};

int evaluateFile(const EvaluateArguments& arguments, const Parameters& parameters)
{
  parameters.experiment.validateBody();
  const std::shared_ptr<const Body> body = makeBody(parameters.experiment.body);
  const InstructionSet instruction_set = parseInstructionSet(parameters.instruction_set);
  RobotSource source(arguments.input);
  source.check(*body);

  noteInterruptions();
  ResultStream results(arguments.output, { arguments.input });
  const int threads = threadCount(parameters);
  const auto farm = makeLocalFarm(body, threads, instruction_set);
  RobotReader robots = source.read(*body);
  const auto window = 4 * static_cast<size_t>(threads) * static_cast<size_t>(body->laneCount(instruction_set));
  const bool complete = OrderedEvaluation(robots, *farm, *body, results, window).run();
  results.close();
  if (!complete)
  {
    std::cerr << "devo_evo: stopped by " << signalName(interruption()) << "; the results so far are written\n";
    return 128 + interruption();
  }
  return EXIT_OK;
}
}  // namespace

void addEvaluateCommand(CLI::App& tool, Command& command)
{
  CLI::App* app =
      tool.add_subcommand("evaluate", "Simulate the robots of a file: JSON lines in, JSON lines out (docs/tool.md).");
  const auto arguments = std::make_shared<EvaluateArguments>();
  app->add_option("FILE", arguments->input, "genomes, one JSON object a line; - for standard input")->required();
  app->add_option("--out", arguments->output, "where the evaluations go instead of standard output")->type_name("FILE");
  const ParameterOptions options(*app, { "body", "physics", "rigid body", "farm" });
  app->footer(
      "Example:\n  devo_evo evaluate genomes.jsonl --out results.jsonl --threads 4 --lifetime 5\n"
      "\"devo_evo parameters\" tells the range of each parameter.");
  app->callback([=, &command] { command = [=] { return evaluateFile(*arguments, options.read()); }; });
}
}  // namespace devo_evo
