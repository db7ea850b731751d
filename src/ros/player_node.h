#pragma once

#include "devo_evo/experiment/parameters.h"
#include "devo_evo/render/colouring.h"
#include "devo_evo/render/scene.h"
#include "ros/robot_source.h"
#include "ros/scene_markers.h"

#include <devo_evo/PlayerState.h>
#include <devo_evo/Show.h>

#include <ros/node_handle.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/transform_broadcaster.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

namespace devo_evo
{
/// Shows a robot living its life, again and again: from an archive, a file or a running evolver. Simulates it while it
/// shows it, and says so if that is not what was recorded.
///
/// Publishes ~robot and ~floor (MarkerArray, ~floor latched), ~state (PlayerState) and the transforms from `world` to
/// `<name>/robot` and `<name>/follow`; offers services ~show (Show), ~pause and ~resume (Trigger). See docs/nodes.md.
/// Works in a thread of its own; services go by the global callback queue, which somebody must serve.
class PlayerNode
{
public:
  /// @throw InvalidInput, ArchiveError if there is no such robot.
  explicit PlayerNode(const Parameters& parameters);
  ~PlayerNode();

  PlayerNode(const PlayerNode&) = delete;
  PlayerNode& operator=(const PlayerNode&) = delete;

  /// Throws what has ended the thread, if anything has.
  void throwFailure();

private:
  using Clock = std::chrono::steady_clock;

  /// What can be changed while it runs.
  struct Orders
  {
    PlayerParameters player;
    std::string output;
    std::shared_ptr<RobotSource> source;
    bool paused = false;
    int64_t version = 0;         ///< counts all changes
    int64_t source_version = 0;  ///< counts changes of the source
  };

  /// The robot on show.
  struct Scene
  {
    ShownRobot robot;
    LifeSurvey life;
    Surroundings surroundings;
    std::unique_ptr<SceneMarkers> markers;
    uint8_t record = PlayerState::NOT_RECORDED;
  };

  /// The last picture of it.
  struct Picture
  {
    RobotFrame frame;
    MotionTrace trace;
  };

  std::shared_ptr<RobotSource> makeSource(const Orders& orders);
  Orders orders();
  void change(const std::function<void(Orders&)>& changing);
  void order(const Show::Request& request);

  void run();
  bool prepare(const Orders& orders);
  void setScene(ShownRobot robot, const Orders& orders);
  void playLife(const Orders& began);
  void checkRecord(const Evaluation& evaluation);
  bool wait(std::chrono::duration<double> time, const Orders& known);
  void show(const Picture& picture, const Orders& orders);
  void broadcast(const RobotFrame& frame, const ros::Time& stamp);
  void publishState(const Picture& picture, const Orders& orders, const ros::Time& stamp);

  bool onShow(Show::Request& request, Show::Response& response);
  bool onPause(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool onResume(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  const BodySettings file_body_;  ///< of robots from files
  const std::string name_;        ///< of the frames
  ros::NodeHandle node_;
  ros::NodeHandle private_node_;
  ros::Publisher robot_publisher_;
  ros::Publisher floor_publisher_;
  ros::Publisher state_publisher_;
  tf2_ros::TransformBroadcaster transforms_;

  std::mutex mutex_;
  std::condition_variable changed_;
  Orders orders_;               ///< guarded by mutex_
  std::exception_ptr failure_;  ///< guarded by mutex_
  std::atomic<bool> stop_{ false };

  std::unique_ptr<Scene> scene_;  ///< of the thread
  double offset_ = 0.0;           ///< [m]

  std::thread thread_;
  ros::ServiceServer show_;
  ros::ServiceServer pause_;
  ros::ServiceServer resume_;
};
}  // namespace devo_evo
