#include "ros/evolver_node.h"

#include "devo_evo/experiment/build_info.h"
#include "devo_evo/experiment/report_text.h"
#include "devo_evo/soft_body/simulation.h"
#include "devo_evo/soft_body/text.h"
#include "ros/conversions.h"
#include "ros/node_main.h"
#include "ros/subscribers.h"

#include <ros/common.h>
#include <ros/console.h>
#include <ros/init.h>
#include <ros/this_node.h>

#include <algorithm>

namespace devo_evo
{
namespace
{
constexpr std::chrono::seconds DIAGNOSTICS_PERIOD{ 1 };
constexpr std::chrono::seconds SHORTEST_PROGRESS{ 1 };  // between lines on progress, which become rarer
constexpr std::chrono::seconds LONGEST_PROGRESS{ 60 };
constexpr std::chrono::minutes FARM_REPORT_PERIOD{ 10 };
constexpr uint32_t REPORT_QUEUE = 10000;  // more than a subscriber that is alive gets behind
constexpr std::chrono::seconds LONGEST_WAIT_FOR_RECORDER{ 15 };
constexpr double LAST_MESSAGES = 0.3;  // for how long subscribers can still be sent what was published last [s]

/// The arguments say where results go; without one, a folder of the user's.
ExperimentSettings settingsOf(const Parameters& parameters)
{
  ExperimentSettings settings = parameters.experiment;
  if (settings.output.empty())
  {
    settings.output = defaultOutput(settings);
  }
  loadFounders(settings);
  settings.validate();
  return settings;
}

Provenance provenanceOf(const BodySettings& body)
{
  Provenance provenance = localProvenance(toString(bestInstructionSet()), *makeBody(body));
  provenance.ros = "roscpp " + std::to_string(ROS_VERSION_MAJOR) + "." + std::to_string(ROS_VERSION_MINOR) + "." +
                   std::to_string(ROS_VERSION_PATCH);
  return provenance;
}

bool isBetter(const EvolvedRobot& candidate, const EvolvedRobot& present)
{
  return candidate.evaluation.valid &&
         (!present.evaluation.valid || candidate.evaluation.fitness > present.evaluation.fitness);
}
}  // namespace

EvolverNode::EvolverNode(const Parameters& parameters) : EvolverNode(parameters, settingsOf(parameters))
{
}

EvolverNode::EvolverNode(const Parameters& parameters, const ExperimentSettings& settings)
  : EvolverNode(parameters, settings, provenanceOf(settings.body))
{
}

EvolverNode::EvolverNode(const Parameters& parameters, const ExperimentSettings& settings, const Provenance& provenance)
  : settings_(settings)
  , archive_(openArchiveForWriting(settings_, provenance))
  , farm_(node_, farmSettings(parameters, settings_.body, provenance.engine_fingerprint), signs_of_life_)
  , experiment_(settings_, *archive_, farm_, *this)
  , archive_services_(node_, settings_.output)
  , idle_warning_(node_.resolveName("simulators"))
  , callbacks_(2)
{
  generation_ = node_.advertise<GenerationSummary>("generation", REPORT_QUEUE);
  champion_ = node_.advertise<EvolvedRobot>("champion", REPORT_QUEUE, true);
  best_publisher_ = node_.advertise<EvolvedRobot>("best", REPORT_QUEUE, true);
  diagnostics_ = node_.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 10);
  evaluation_settings_ = node_.advertise<EvaluationSettings>("settings", 1, true);
  evaluation_settings_.publish(toMsg(settings_.body));
  pause_ = node_.advertiseService("pause", &EvolverNode::pause, this);
  resume_ = node_.advertiseService("resume", &EvolverNode::resume, this);
  stop_ = node_.advertiseService("stop", &EvolverNode::stop, this);
  std::vector<std::string> services = archive_services_.names();
  services.insert(services.end(), { pause_.getService(), resume_.getService(), stop_.getService() });
  master_watch_ = std::make_unique<MasterWatch>(std::move(services), signs_of_life_, node_.resolveName("simulators"));

  status_.output = settings_.output;
  status_.trials = settings_.trials;
  status_.generations = settings_.generations;
  status_.remaining_s = Evaluation::NONE;
  if (parameters.record)
  {
    awaitRecorder();
  }
  takeUp();
}

/// Returns once a recorder hears everything. @throw std::runtime_error if there is none.
void EvolverNode::awaitRecorder()
{
  const auto interrupted = [] { return !ros::ok(); };
  if (!awaitSubscribers({ generation_, champion_, best_publisher_, diagnostics_, evaluation_settings_ },
                        LONGEST_WAIT_FOR_RECORDER, generation_.getTopic(), interrupted) &&
      generation_.getNumSubscribers() == 0 && ros::ok())
  {
    throw std::runtime_error("record is true, but nobody has subscribed to " + generation_.getTopic() + " for " +
                             toText(static_cast<int64_t>(LONGEST_WAIT_FOR_RECORDER.count())) +
                             " s; start a recorder, or set record to false");
  }
}

/// Counts and publishes what earlier runs have done.
void EvolverNode::takeUp()
{
  for (const auto& [number, state] : archive_->trialStates())
  {
    if (number > settings_.trials)
    {
      continue;
    }
    status_.generations_committed += state.generation + 1;
    status_.trials_finished += state.generation >= settings_.generations ? 1 : 0;
    const ArchivedIndividual champion = archive_->readIndividual(number, archive_->championOf(number));
    publishChampion(toMsg(champion, settings_));
  }
}

RunOutcome EvolverNode::run()
{
  const ScopedInterruption interruption;
  say("evolving in " + settings_.output + (status_.generations_committed > 0 ? ", resumed" : ""));
  idle_warning_.update(true);
  started_ = Clock::now();
  next_farm_report_ = started_ + FARM_REPORT_PERIOD;
  callbacks_.start();
  const RunOutcome outcome = experiment_.run();
  publishDiagnostics();
  sayWhoWorked();
  say((outcome == RunOutcome::FINISHED ? "finished\n" : "stopped\n") + resultsText(*archive_, settings_.output) +
      (outcome == RunOutcome::FINISHED ? "To go on: the same command with more generations or trials"
                                       : "To go on: the same command"));
  ros::WallDuration(LAST_MESSAGES).sleep();
  return outcome;
}

void EvolverNode::sayWhoWorked()
{
  std::string text = workersText(farm_.status());
  if (!text.empty())
  {
    text.pop_back();  // the end of the last line, which say() adds
    say(text);
  }
}

bool EvolverNode::close()
{
  callbacks_.stop();
  const bool master_watch_ended = master_watch_->close();
  return farm_.close() && master_watch_ended;
}

void EvolverNode::generationCommitted(const GenerationReport& report)
{
  ++status_.generations_committed;
  status_.trials_finished += report.record.generation == settings_.generations ? 1 : 0;
  status_.total_evaluations = report.total_evaluations;
  status_.evaluations_per_s = report.evaluations_per_s;
  status_.remaining_s = report.remaining_s;
  GenerationSummary summary = toMsg(report, settings_);
  countSimulators(farm_.status(), summary);
  generation_.publish(summary);
  publishChampion(toMsg(report.champion, report.record.generation, settings_));
  showProgress(report);
}

/// A line at most every second, and ever fewer the longer it takes; but always one on a trial's last generation.
void EvolverNode::showProgress(const GenerationReport& report)
{
  const Clock::time_point now = Clock::now();
  if (now < next_progress_ && report.record.generation != settings_.generations)
  {
    return;
  }
  say(progressText(report, settings_));
  next_progress_ = now + std::clamp<Clock::duration>((now - started_) / 50, SHORTEST_PROGRESS, LONGEST_PROGRESS);
}

void EvolverNode::publishChampion(const EvolvedRobot& champion)
{
  champion_.publish(champion);
  if (!best_ || isBetter(champion, *best_))
  {
    best_ = champion;
    best_publisher_.publish(champion);
  }
}

void EvolverNode::tick()
{
  if (ScopedInterruption::happened() || !ros::ok())
  {
    experiment_.stopNow();
    return;
  }
  const Clock::time_point now = Clock::now();
  if (now - diagnosed_ >= DIAGNOSTICS_PERIOD)
  {
    diagnosed_ = now;
    publishDiagnostics();
  }
}

void EvolverNode::publishDiagnostics()
{
  const std::vector<WorkerStatus> workers = farm_.status();
  status_.paused = experiment_.paused();
  diagnostics_.publish(diagnosticsOf(ros::this_node::getName(), status_, workers));
  idle_warning_.update(status_.paused || usableWorkers(workers) > 0);
  if (Clock::now() >= next_farm_report_)
  {
    next_farm_report_ = Clock::now() + FARM_REPORT_PERIOD;
    sayWhoWorked();
  }
}

bool EvolverNode::pause(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response)
{
  experiment_.pause();
  response.success = true;
  response.message = "paused: generations that run are finished, no new one begins until resume is called";
  ROS_INFO_STREAM(response.message);
  return true;
}

bool EvolverNode::resume(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response)
{
  response.success = true;
  response.message = experiment_.paused() ? "resumed" : "was not paused";
  experiment_.resume();
  ROS_INFO_STREAM(response.message);
  return true;
}

bool EvolverNode::stop(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response)
{
  experiment_.stopAfterGeneration();
  response.success = true;
  response.message = "stopping: generations that run are finished first";
  ROS_INFO_STREAM(response.message);
  return true;
}
}  // namespace devo_evo
