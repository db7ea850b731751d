#include "ros/batch_display.h"

#include "devo_evo/evolution/individual.h"
#include "ros/conversions.h"
#include "ros/scene_markers.h"

#include <ros/console.h>

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>

namespace devo_evo
{
namespace
{
constexpr std::chrono::milliseconds LOOK_PERIOD{ 200 };  // between looks whether somebody subscribes
constexpr std::chrono::seconds GONE_AFTER{ 5 };          // without a word, a simulator has no place any more
constexpr double LIFETIME_OF_MARKERS = 2.0;              // after which the last picture goes away [s]
constexpr double PLACE_WIDTH = 4.0;                      // [body lengths]
constexpr size_t MARKERS_PER_PLACE = 100;                // of one namespace, more than any robot has

/// Lets the calling thread have only what nobody else wants.
void lowerPriority()
{
  constexpr int lowest = 19;
  setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), lowest);  // of this thread, on Linux
}
}  // namespace

BatchDisplay::BatchDisplay(ros::NodeHandle node, std::string name)
  : name_(std::move(name))
  , node_(std::move(node))
  , publisher_(node_.advertise<visualization_msgs::MarkerArray>("voxels", 2))
  , thread_(&BatchDisplay::run, this)
{
}

BatchDisplay::~BatchDisplay()
{
  {
    std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  offered_.notify_all();
  thread_.join();
}

void BatchDisplay::offer(const BodySettings& settings, const std::vector<EvaluationRequest>& robots,
                         const std::vector<Evaluation>& evaluations)
{
  if (robots.empty() || !watched())
  {
    return;
  }
  const auto worse = [](const Evaluation& a, const Evaluation& b)
  { return b.valid && (!a.valid || a.fitness < b.fitness); };
  const auto best = std::max_element(evaluations.begin(), evaluations.end(), worse);
  if (!best->valid)
  {
    return;
  }
  {
    std::lock_guard<std::mutex> lock(mutex_);
    robot_ = Robot{ settings, robots[static_cast<size_t>(best - evaluations.begin())], *best };
  }
  offered_.notify_all();
}

void BatchDisplay::run()
{
  lowerPriority();
  try
  {
    while (!stop_)
    {
      if (const std::optional<Robot> robot = take())
      {
        play(*robot);
      }
    }
  }
  catch (const EvaluationAbandoned&)  // told to stop
  {
  }
}

/// The robot to show next, if there is one soon.
std::optional<BatchDisplay::Robot> BatchDisplay::take()
{
  std::unique_lock<std::mutex> lock(mutex_);
  offered_.wait_for(lock, LOOK_PERIOD, [this] { return stop_ || robot_; });
  std::optional<Robot> robot = std::move(robot_);
  robot_.reset();
  return robot;
}

/// Shows one life, in real time or slower where the processor has no time left.
void BatchDisplay::play(const Robot& robot)
{
  announcements_ = node_.subscribe("simulators", 100, &BatchDisplay::heardFrom, this);
  const double body_length = makeAppearance(robot.settings)->surroundings().body_length;
  const std::string caption = individualName(robot.request.trial, robot.request.id);
  LifePlayback life(robot.settings, robot.request.program);
  MotionTrace trace;
  Clock::time_point due = Clock::now();
  for (int64_t picture = 0; watched() && !life.finished(); ++picture)
  {
    life.advanceTo(static_cast<double>(picture) / FRAME_RATE, &stop_);
    const RobotFrame frame = life.frame();
    trace.add(frame.time_since_birth, frame.center_of_mass);
    const size_t place = this->place();
    if (place < MAX_SHOWN)
    {
      const SceneMarkers scene(robot.settings,
                               { -PLACE_WIDTH * body_length * static_cast<double>(place + 1), 0.0, 0.0 });
      visualization_msgs::MarkerArray markers = scene.robot(frame, Colouring::RESTING_LENGTH);
      append(markers, scene.annotations(frame, trace, caption));
      for (visualization_msgs::Marker& marker : markers.markers)
      {
        marker.id += static_cast<int32_t>(MARKERS_PER_PLACE * place);
        marker.lifetime = ros::Duration(LIFETIME_OF_MARKERS);
      }
      setStamp(markers, wallStamp());
      publisher_.publish(markers);
    }
    due = std::max(due + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1.0 / FRAME_RATE)),
                   Clock::now());
    std::unique_lock<std::mutex> lock(mutex_);
    offered_.wait_until(lock, due, [this] { return stop_.load(); });
  }
  announcements_.shutdown();
}

void BatchDisplay::heardFrom(const SimulatorAnnouncement& announcement)
{
  try
  {
    validate(announcement);
  }
  catch (const InvalidInput& e)
  {
    ROS_WARN_STREAM_THROTTLE(10.0, "ignored an announcement of a simulator: " << e.what());
    return;
  }
  std::lock_guard<std::mutex> lock(mutex_);
  heard_[announcement.name] = Clock::now();
}

/// How many of the simulators come before this one.
size_t BatchDisplay::place()
{
  std::lock_guard<std::mutex> lock(mutex_);
  const Clock::time_point oldest = Clock::now() - GONE_AFTER;
  for (auto simulator = heard_.begin(); simulator != heard_.end();)
  {
    simulator = simulator->second < oldest ? heard_.erase(simulator) : std::next(simulator);
  }
  return static_cast<size_t>(std::distance(heard_.begin(), heard_.lower_bound(name_)));
}
}  // namespace devo_evo
