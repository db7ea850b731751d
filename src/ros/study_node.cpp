#include "ros/study_node.h"

#include "devo_evo/experiment/build_info.h"
#include "ros/diagnostics.h"
#include "ros/node_main.h"
#include "ros/ros_farm.h"
#include "ros/simulator_processes.h"

#include <ros/init.h>
#include <ros/this_node.h>

#include <algorithm>

namespace devo_evo
{
namespace
{
constexpr std::chrono::seconds LOOK_PERIOD{ 1 };        // whether somebody works
constexpr std::chrono::seconds SHORTEST_PROGRESS{ 1 };  // between lines on progress, which become rarer
constexpr std::chrono::seconds LONGEST_PROGRESS{ 60 };

/// A farm that is closed at its end, and says then whether that went well.
class ClosingFarm : public Farm
{
public:
  ClosingFarm(const ros::NodeHandle& node, const SimulatorFarmSettings& settings,
              std::shared_ptr<SignsOfLife> signs_of_life, std::function<void(bool)> closed)
    : farm_(node, settings, std::move(signs_of_life)), closed_(std::move(closed))
  {
  }
  ~ClosingFarm() override { closed_(farm_.close()); }

  void submit(std::vector<EvaluationRequest> requests) override { farm_.submit(std::move(requests)); }
  std::vector<EvaluationResult> collect(std::chrono::milliseconds timeout) override { return farm_.collect(timeout); }
  std::vector<WorkerStatus> status() const override { return farm_.status(); }

private:
  RosFarm farm_;
  const std::function<void(bool)> closed_;
};

Parameters withOutput(Parameters parameters)
{
  std::string& output = parameters.experiment.output;
  output = output.empty() ? defaultStudyOutput(parameters) : output;
  validateStudy(parameters);
  return parameters;
}
}  // namespace

StudyNode::StudyNode(const Parameters& parameters)
  : parameters_(withOutput(parameters))
  , callbacks_(2)
  , idle_warning_(node_.resolveName("simulators"))
  , master_watch_({}, signs_of_life_, node_.resolveName("simulators"))
  , diagnostics_(node_.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 10))
{
  status_.output = parameters_.experiment.output;
  status_.scale = toString(parameters_.study.scale);
}

RunOutcome StudyNode::run()
{
  const ScopedInterruption interruption;
  const int workers = parameters_.simulators == 0 ? coreCount() : parameters_.simulators;
  const std::string& output = parameters_.experiment.output;
  say("study of scale " + toString(parameters_.study.scale) + " in " + output + "\n" +
      estimateText(parameters_, workers, bestInstructionSet()));
  const Provenance provenance = localProvenance(toString(bestInstructionSet()), *makeBody(parameters_.experiment.body));
  const auto make_farm = [&](const BodySettings& body) { return makeFarm(body); };
  callbacks_.start();
  const RunOutcome outcome = runStudy(parameters_, provenance, make_farm, *this);
  say(outcome == RunOutcome::FINISHED ? "finished\nStudy: " + output
                                      : "stopped\nStudy: " + output + "\nTo go on: the same command");
  return outcome;
}

bool StudyNode::close()
{
  callbacks_.stop();
  return master_watch_.close() && clean_;
}

std::unique_ptr<Farm> StudyNode::makeFarm(const BodySettings& body)
{
  const auto closed = [this](bool clean)
  {
    clean_ = clean_ && clean;
    workers_ = nullptr;
  };
  const uint64_t fingerprint = makeBody(body)->engineFingerprint(bestInstructionSet());
  auto farm =
      std::make_unique<ClosingFarm>(node_, farmSettings(parameters_, body, fingerprint), signs_of_life_, closed);
  workers_ = [&farm = *farm] { return farm.status(); };
  idle_warning_.update(true);
  return farm;
}

void StudyNode::partBegun(StudyPart part, size_t number, size_t parts)
{
  status_.part = toString(part);
  status_.number = static_cast<int64_t>(number);
  status_.parts = static_cast<int64_t>(parts);
  status_.progress.clear();
}

void StudyNode::say(const std::string& line)
{
  devo_evo::say(line);
}

/// A line at most every second, and ever fewer the longer it takes.
void StudyNode::showProgress(const std::string& line)
{
  status_.progress = line;
  const Clock::time_point now = Clock::now();
  if (now >= next_progress_)
  {
    say(line);
    next_progress_ = now + std::clamp<Clock::duration>((now - started_) / 50, SHORTEST_PROGRESS, LONGEST_PROGRESS);
  }
}

bool StudyNode::stopRequested()
{
  const Clock::time_point now = Clock::now();
  if (now >= next_look_)
  {
    next_look_ = now + LOOK_PERIOD;
    const auto workers = workers_ ? std::optional(workers_()) : std::nullopt;
    idle_warning_.update(!workers || usableWorkers(*workers) > 0);
    diagnostics_.publish(diagnosticsOf(ros::this_node::getName(), status_, workers));
  }
  return ScopedInterruption::happened() || !ros::ok();
}
}  // namespace devo_evo
