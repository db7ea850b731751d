#pragma once

#include "devo_evo/bodies/bodies.h"
#include "devo_evo/farm/farm.h"
#include "devo_evo/soft_body/evaluation.h"
#include "devo_evo/soft_body/settings.h"

#include <devo_evo/SimulatorAnnouncement.h>

#include <ros/node_handle.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace devo_evo
{
/// Shows the best robot of the last batch that a simulator has evaluated, on topic `voxels` (MarkerArray), while
/// somebody subscribes. Simulates it again, in real time, in a thread of the lowest priority: evaluations do not wait
/// for it. Simulators stand side by side, in the order of their names; those beyond MAX_SHOWN show nothing.
class BatchDisplay
{
public:
  static constexpr size_t MAX_SHOWN = 8;
  static constexpr double FRAME_RATE = 10.0;  ///< [1/s]

  /// @param name of the simulator, as it announces itself.
  BatchDisplay(ros::NodeHandle node, std::string name);
  ~BatchDisplay();

  BatchDisplay(const BatchDisplay&) = delete;
  BatchDisplay& operator=(const BatchDisplay&) = delete;

  /// Tells of a batch; takes no time unless somebody subscribes. From any thread.
  void offer(const BodySettings& settings, const std::vector<EvaluationRequest>& robots,
             const std::vector<Evaluation>& evaluations);

private:
  using Clock = std::chrono::steady_clock;

  struct Robot
  {
    BodySettings settings;
    EvaluationRequest request;
    Evaluation evaluation;
  };

  void run();
  void play(const Robot& robot);
  std::optional<Robot> take();
  bool watched() const { return publisher_.getNumSubscribers() > 0; }
  void heardFrom(const SimulatorAnnouncement& announcement);
  size_t place();

  const std::string name_;
  ros::NodeHandle node_;
  ros::Publisher publisher_;
  ros::Subscriber announcements_;  ///< of the thread; only while somebody subscribes
  std::atomic<bool> stop_{ false };
  std::mutex mutex_;
  std::condition_variable offered_;
  std::optional<Robot> robot_;                      ///< guarded by mutex_
  std::map<std::string, Clock::time_point> heard_;  ///< guarded by mutex_: simulators, and when each was heard from
  std::thread thread_;
};
}  // namespace devo_evo
