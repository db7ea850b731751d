#include "ros/simulator_node.h"

#include "devo_evo/experiment/build_info.h"
#include "devo_evo/soft_body/text.h"
#include "ros/checked_service.h"
#include "ros/conversions.h"
#include "ros/message_reader.h"
#include "ros/node_main.h"
#include "ros/subscribers.h"

#include <ros/console.h>
#include <ros/this_node.h>

#include <unistd.h>

namespace devo_evo
{
namespace
{
constexpr uint32_t TELEMETRY_QUEUE = 10000;  // more than a subscriber that is alive gets behind
constexpr std::chrono::seconds LONGEST_WAIT_FOR_SUBSCRIBERS{ 2 };

void requireSameEngine(uint64_t wanted, uint64_t own, const std::string& kind)
{
  if (wanted != 0 && wanted != own)
  {
    throw InvalidInput("the engine fingerprint of this simulator for " + kind + " bodies is " + hashToString(own) +
                       ", its version " + versionText() + "; the engine fingerprint asked for is " +
                       hashToString(wanted));
  }
}

std::vector<DevelopmentalProgram> programsOf(const std::vector<EvaluationRequest>& robots)
{
  std::vector<DevelopmentalProgram> programs;
  for (const EvaluationRequest& robot : robots)
  {
    programs.push_back(robot.program);
  }
  return programs;
}
}  // namespace

SimulatorNode::SimulatorNode(InstructionSet instruction_set, double announcement_period_s)
  : instruction_set_(instruction_set)
  , announcement_period_s_(announcement_period_s)
  , fingerprints_(engineFingerprints(instruction_set))
  , private_node_("~")
  , display_(node_, ros::this_node::getName())
  , evaluation_thread_(1, &requests_)
{
  announcements_ = node_.advertise<SimulatorAnnouncement>("simulators", 1, true);
  velocity_ = node_.advertise<VelocityTelemetry>("velocity", TELEMETRY_QUEUE);
  private_node_.setCallbackQueue(&requests_);
  service_ = advertiseCheckedService<EvaluateGenomes>(private_node_, "evaluate",
                                                      [this](const auto& request, const auto& caller, auto& response)
                                                      { return evaluate(request, caller, response); });
  evaluation_thread_.start();
  announcement_timer_ = node_.createSteadyTimer(ros::WallDuration(announcement_period_s),
                                                [this](const ros::SteadyTimerEvent&) { announce(); });
  awaitSubscribers({ velocity_ }, LONGEST_WAIT_FOR_SUBSCRIBERS);  // once it is announced, work begins
  announce();
  master_watch_ = std::make_unique<MasterWatch>(std::vector<std::string>{ service_.getService() });
  ROS_INFO_STREAM("simulating with " << toString(instruction_set) << ", " << laneCount(instruction_set)
                                     << " robots in lock-step; engine fingerprint "
                                     << hashToString(fingerprints_.at(toString(BodyKind::SOFT))));
}

SimulatorNode::~SimulatorNode()
{
  announcement_timer_.stop();
  stop_ = true;
  service_.shutdown();
  evaluation_thread_.stop();
}

bool SimulatorNode::evaluate(const ros::SerializedMessage& request, const std::string& caller,
                             EvaluateGenomes::Response& response)
{
  busy_ = true;
  bool answered = true;
  try
  {
    answer(readMessage<EvaluateGenomes::Request>(request), caller, response);
  }
  catch (const EvaluationAbandoned&)
  {
    answered = false;
  }
  catch (const std::exception& e)
  {
    response.evaluations.clear();
    response.error = e.what();
    ROS_ERROR_STREAM("refused a request of " << caller << ": " << e.what());
  }
  busy_ = false;
  return answered;
}

void SimulatorNode::answer(const EvaluateGenomes::Request& request, const std::string& caller,
                           EvaluateGenomes::Response& response)
{
  const BodySettings settings = fromMsg(request.settings);
  const std::shared_ptr<const Body> body = makeBody(settings);
  requireSameEngine(request.engine_fingerprint, fingerprints_.at(body->kind()), body->kind());
  if (const std::optional<std::string> reason = quarantineOf(request))
  {
    beQuarantined(*reason, caller);
    return;
  }
  if (!quarantine_.empty())
  {
    throw InvalidInput("this simulator was quarantined by " + quarantine_);
  }
  const std::vector<EvaluationRequest> robots = robotsOf(request, *body);
  const std::vector<Evaluation> evaluations = body->evaluate(programsOf(robots), instruction_set_, &stop_);
  for (size_t i = 0; i < robots.size(); ++i)
  {
    response.evaluations.push_back(toMsg(evaluations[i], robots[i].trial, robots[i].id, *body));
    velocity_.publish(telemetryOf(robots[i], evaluations[i], *body, ros::this_node::getName()));
  }
  display_.offer(settings, robots, evaluations);
  evaluations_ += static_cast<int64_t>(robots.size());
}

void SimulatorNode::beQuarantined(const std::string& reason, const std::string& by)
{
  quarantine_ = by + ": " + reason;
  ROS_ERROR_STREAM(
      "quarantined by " << quarantine_ << ". This simulator evaluates nothing any more. Look at the memory "
                        << "and the processor of host " << hostName() << ", then end it and start another");
}

void SimulatorNode::announce()
{
  SimulatorAnnouncement announcement;
  announcement.header.stamp = wallStamp();
  announcement.name = ros::this_node::getName();
  announcement.service = service_.getService();
  announcement.host = hostName();
  announcement.pid = static_cast<uint32_t>(getpid());
  announcement.version = versionText();
  for (const auto& [kind, fingerprint] : fingerprints_)
  {
    BodyEngine engine;
    engine.body = kind;
    engine.fingerprint = fingerprint;
    announcement.engines.push_back(engine);
  }
  announcement.instruction_set = toString(instruction_set_);
  announcement.lanes = laneCount(instruction_set_);
  announcement.period = announcement_period_s_;
  announcement.busy = busy_;
  announcement.evaluations = evaluations_;
  announcement.processor = processorName();
  announcements_.publish(announcement);
}
}  // namespace devo_evo
