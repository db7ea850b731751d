#include "ros/player_node.h"

#include "devo_evo/experiment/report_text.h"
#include "ros/conversions.h"
#include "ros/robot_transforms.h"

#include <ros/console.h>
#include <ros/init.h>
#include <ros/names.h>
#include <ros/this_node.h>

#include <algorithm>

namespace devo_evo
{
namespace
{
constexpr std::chrono::milliseconds REST_PERIOD{ 500 };  // between pictures of a robot that does not move
constexpr std::chrono::milliseconds LOOK_PERIOD{ 100 };  // between looks for a robot that is not there yet
constexpr std::chrono::seconds LONGEST_LOOK{ 3 };        // for a robot that somebody asks for by service
constexpr double WARNING_PERIOD = 30.0;                  // [s]

std::string withoutNamespace(const std::string& name)
{
  return name.substr(name.rfind('/') + 1);
}
}  // namespace

PlayerNode::PlayerNode(const Parameters& parameters)
  : file_body_(parameters.experiment.body), name_(withoutNamespace(ros::this_node::getName())), private_node_("~")
{
  robot_publisher_ = private_node_.advertise<visualization_msgs::MarkerArray>("robot", 100);
  floor_publisher_ = private_node_.advertise<visualization_msgs::MarkerArray>("floor", 10, true);
  state_publisher_ = private_node_.advertise<PlayerState>("state", 100);
  orders_.player = parameters.player;
  orders_.output = parameters.experiment.output;
  orders_.source = makeSource(orders_);
  show_ = private_node_.advertiseService("show", &PlayerNode::onShow, this);
  pause_ = private_node_.advertiseService("pause", &PlayerNode::onPause, this);
  resume_ = private_node_.advertiseService("resume", &PlayerNode::onResume, this);
  thread_ = std::thread(&PlayerNode::run, this);
}

PlayerNode::~PlayerNode()
{
  {
    std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
    orders_.source->stop();
  }
  changed_.notify_all();
  thread_.join();
}

void PlayerNode::throwFailure()
{
  std::lock_guard<std::mutex> lock(mutex_);
  if (failure_)
  {
    std::rethrow_exception(failure_);
  }
}

// ---- orders --------------------------------------------------------------------------------------------------------

std::shared_ptr<RobotSource> PlayerNode::makeSource(const Orders& orders)
{
  const PlayerParameters& player = orders.player;
  if (!player.genome_file.empty())
  {
    return makeFileSource(player.genome_file, player.individual == "best" ? "" : player.individual, file_body_);
  }
  const RobotChoice choice = parseRobotChoice(player.individual);
  if (orders.output.empty())
  {
    return makeEvolverSource(node_, choice);
  }
  if (orders.output[0] != '/')
  {
    throw InvalidInput("output is \"" + orders.output + "\"; it must be an absolute path");
  }
  return makeArchiveSource(orders.output, choice);
}

PlayerNode::Orders PlayerNode::orders()
{
  std::lock_guard<std::mutex> lock(mutex_);
  return orders_;
}

void PlayerNode::change(const std::function<void(Orders&)>& changing)
{
  {
    std::lock_guard<std::mutex> lock(mutex_);
    changing(orders_);
    ++orders_.version;
  }
  changed_.notify_all();
}

/// @throw InvalidInput, ArchiveError if it cannot be done.
void PlayerNode::order(const Show::Request& request)
{
  Orders wanted = orders();
  Parameters checked;
  checked.player = wanted.player;
  const auto set = [&](const char* name, const std::string& value)
  {
    if (!value.empty())
    {
      parameterSpec(name).set(checked, value);
    }
  };
  if (!request.output.empty() || !request.genome_file.empty())
  {
    wanted.output = request.output.empty() ? wanted.output : request.output;
    checked.player.genome_file = "";
    checked.player.individual = "best";
  }
  set("individual", request.individual);
  set("genome_file", request.genome_file);
  set("colour", request.colour);
  if (request.speed != 0.0)
  {
    parameterSpec("speed").set(checked, request.speed);
  }
  wanted.player = checked.player;
  const bool another_robot = !(request.individual.empty() && request.genome_file.empty() && request.output.empty());
  if (another_robot)
  {
    wanted.source = makeSource(wanted);
    const Clock::time_point end = Clock::now() + LONGEST_LOOK;
    while (!wanted.source->look())  // throws if there is no such robot
    {
      if (stop_ || Clock::now() > end)
      {
        throw InvalidInput(wanted.source->waitingFor());
      }
      std::this_thread::sleep_for(LOOK_PERIOD);
    }
  }
  change(
      [&](Orders& orders)
      {
        orders.player = wanted.player;
        orders.output = wanted.output;
        orders.source = wanted.source;
        orders.source_version += another_robot ? 1 : 0;
      });
}

bool PlayerNode::onShow(Show::Request& request, Show::Response& response)
{
  try
  {
    order(request);
    response.success = true;
  }
  catch (const std::exception& e)
  {
    response.message = e.what();
    ROS_ERROR_STREAM("cannot show that: " << e.what());
  }
  return true;
}

bool PlayerNode::onPause(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response)
{
  change([](Orders& orders) { orders.paused = true; });
  response.success = true;
  response.message = "paused";
  return true;
}

bool PlayerNode::onResume(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response)
{
  change([](Orders& orders) { orders.paused = false; });
  response.success = true;
  response.message = "resumed";
  return true;
}

// ---- the thread ----------------------------------------------------------------------------------------------------

void PlayerNode::run()
{
  try
  {
    while (!stop_)
    {
      const Orders now = orders();
      if (prepare(now))
      {
        playLife(now);
      }
      else
      {
        wait(LOOK_PERIOD, now);
      }
    }
  }
  catch (const EvaluationAbandoned&)  // told to stop
  {
  }
  catch (...)
  {
    std::lock_guard<std::mutex> lock(mutex_);
    failure_ = std::current_exception();
    ros::requestShutdown();
  }
}

/// Sets the scene for the robot that is to be shown now. @return whether there is one.
bool PlayerNode::prepare(const Orders& orders)
{
  std::optional<ShownRobot> robot;
  try
  {
    robot = orders.source->look();
  }
  catch (const ArchiveError& e)
  {
    ROS_WARN_STREAM_THROTTLE(WARNING_PERIOD, e.what());
  }
  if (!robot)
  {
    ROS_INFO_STREAM_THROTTLE(WARNING_PERIOD, "waiting: " << orders.source->waitingFor());
    return false;
  }
  if (!scene_ || scene_->robot.name != robot->name || !(scene_->robot.program == robot->program))
  {
    setScene(std::move(*robot), orders);
  }
  return true;
}

void PlayerNode::setScene(ShownRobot robot, const Orders& orders)
{
  auto scene = std::make_unique<Scene>();
  scene->life = surveyLife(robot, &stop_);
  scene->surroundings = makeAppearance(robot.body)->surroundings();
  offset_ = orders.player.offset * scene->surroundings.body_length;
  scene->markers = std::make_unique<SceneMarkers>(robot.body, Eigen::Vector3d(offset_, 0.0, 0.0));
  scene->robot = std::move(robot);
  scene_ = std::move(scene);
  checkRecord(scene_->life.evaluation);
  ROS_INFO_STREAM("showing " << captionText(scene_->robot, scene_->life.evaluation, 0.0)
                             << (scene_->record == PlayerState::AGREES ? ", as recorded" : ""));
  visualization_msgs::MarkerArray floor = nothing();
  append(floor, scene_->markers->floor(floorPlan(scene_->life, scene_->surroundings)));
  floor_publisher_.publish(floor);
  robot_publisher_.publish(nothing());
}

/// Compares a life with what was recorded of the robot, and says so if it is another.
void PlayerNode::checkRecord(const Evaluation& evaluation)
{
  if (!scene_->robot.recorded || scene_->record == PlayerState::DIFFERS)
  {
    return;
  }
  const std::string difference = disagreement(scene_->robot, evaluation);
  scene_->record = difference.empty() ? PlayerState::AGREES : PlayerState::DIFFERS;
  if (!difference.empty())
  {
    ROS_ERROR_STREAM(difference << ". It was recorded by another version of devo_evo, or changed since");
  }
}

/// Shows a life from birth to end, and its end for a while; less if another robot is ordered meanwhile.
void PlayerNode::playLife(const Orders& began)
{
  LifePlayback life(scene_->robot.body, scene_->robot.program);
  Picture picture;
  Orders now = began;
  double time = 0.0;
  const auto rest = [&](std::chrono::duration<double> longest)
  {
    const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(longest);
    while (!stop_ && now.source_version == began.source_version && (now.paused || Clock::now() < end))
    {
      const std::chrono::duration<double> period = REST_PERIOD, left = end - Clock::now();
      if (wait(now.paused ? period : std::min(period, left), now))
      {
        now = orders();
      }
      show(picture, now);
    }
  };
  Clock::time_point due = Clock::now();
  while (!stop_ && now.source_version == began.source_version)
  {
    life.advanceTo(time, &stop_);
    RobotFrame frame = life.frame();
    if (life.diverged() || !frame.finite())
    {
      break;
    }
    picture.trace.add(frame.time_since_birth, frame.center_of_mass);
    picture.frame = std::move(frame);
    show(picture, now);
    if (life.finished())
    {
      checkRecord(life.evaluation());
      break;
    }
    const std::chrono::duration<double> period(1.0 / now.player.frame_rate);
    due += std::chrono::duration_cast<Clock::duration>(period);
    const double late = std::chrono::duration<double>(Clock::now() - due) / period;
    const double skipped = std::max(0.0, std::floor(late));  // pictures that this machine has no time for
    time += (1.0 + skipped) * period.count() * now.player.speed;
    due += std::chrono::duration_cast<Clock::duration>(skipped * period);
    if (wait(due - Clock::now(), now))
    {
      now = orders();
    }
    if (now.paused)
    {
      rest(std::chrono::duration<double>::zero());
      due = Clock::now();
    }
  }
  rest(std::chrono::duration<double>(now.player.loop_pause));
}

/// Waits, but not longer than until the orders are others than those known. @return whether they are.
bool PlayerNode::wait(std::chrono::duration<double> time, const Orders& known)
{
  std::unique_lock<std::mutex> lock(mutex_);
  const auto changed = [&] { return stop_ || orders_.version != known.version; };
  return changed_.wait_for(lock, time, changed);
}

// ---- what is published ---------------------------------------------------------------------------------------------

void PlayerNode::show(const Picture& picture, const Orders& orders)
{
  if (picture.frame.parts.empty())  // it has diverged before there was anything to show
  {
    return;
  }
  const ros::Time stamp = wallStamp();
  broadcast(picture.frame, stamp);
  publishState(picture, orders, stamp);
  if (robot_publisher_.getNumSubscribers() == 0)
  {
    return;
  }
  const std::string warning = scene_->record == PlayerState::DIFFERS ? "\nNOT AS RECORDED" : "";
  visualization_msgs::MarkerArray markers = scene_->markers->robot(picture.frame, parseColouring(orders.player.colour));
  append(markers, scene_->markers->annotations(
                      picture.frame, picture.trace,
                      captionText(scene_->robot, scene_->life.evaluation, picture.frame.time_since_birth) + warning));
  setStamp(markers, stamp);
  robot_publisher_.publish(markers);
}

void PlayerNode::broadcast(const RobotFrame& frame, const ros::Time& stamp)
{
  const Eigen::Vector3d center = frame.center_of_mass + Eigen::Vector3d(offset_, 0.0, 0.0);
  transforms_.sendTransform(robotTransforms(name_, center, frame.orientation, stamp));
}

void PlayerNode::publishState(const Picture& picture, const Orders& orders, const ros::Time& stamp)
{
  const ShownRobot& robot = scene_->robot;
  PlayerState state;
  state.header.stamp = stamp;
  state.header.frame_id = WORLD_FRAME;
  state.individual = robot.name;
  state.trial = robot.descent ? robot.descent->trial : -1;
  state.id = robot.descent ? robot.descent->id : -1;
  state.born = robot.descent ? robot.descent->generation : -1;
  state.age = robot.descent ? robot.descent->age : -1;
  state.treatment = robot.descent ? robot.descent->treatment : "";
  state.morphology_window = robot.descent ? robot.descent->morphology_window : Evaluation::NONE;
  state.control_window = robot.descent ? robot.descent->control_window : Evaluation::NONE;
  state.fitness = scene_->life.evaluation.fitness;
  state.record = scene_->record;
  state.time = picture.frame.time_since_birth;
  const Surroundings& surroundings = scene_->surroundings;
  const Eigen::Vector3d place = surroundings.onFloor(picture.frame.center_of_mass);
  state.displacement = (place.y() - scene_->life.birthplace.y()) / surroundings.body_length;
  state.velocity = surroundings.onFloor(picture.trace.velocity()).y() / surroundings.body_length;
  state.height = place.z() / surroundings.body_length;
  state.paused = orders.paused;
  state.speed = orders.player.speed;
  state.colour = orders.player.colour;
  state_publisher_.publish(state);
}
}  // namespace devo_evo
