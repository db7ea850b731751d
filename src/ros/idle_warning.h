#pragma once

#include <ros/console.h>

#include <algorithm>
#include <chrono>
#include <string>

namespace devo_evo
{
/// Warns, ever more rarely, while no simulator takes work.
class IdleWarning
{
public:
  /// @param topic on which simulators announce themselves, resolved.
  explicit IdleWarning(std::string topic) : topic_(std::move(topic)) {}

  /// Told about every second. @param content whether somebody works, or need not.
  void update(bool content)
  {
    const Clock::time_point now = Clock::now();
    if (content)
    {
      last_content_ = now;
      next_warning_ = FIRST;
    }
    else if (now - last_content_ >= next_warning_)
    {
      ROS_WARN_STREAM("waiting: no simulator has announced itself on "
                      << topic_ << "; start some with: roslaunch devo_evo simulators.launch");
      next_warning_ = std::min(2 * next_warning_, LONGEST);
      last_content_ = now;
    }
  }

private:
  using Clock = std::chrono::steady_clock;

  static constexpr std::chrono::seconds FIRST{ 5 };      // after how long without a simulator
  static constexpr std::chrono::seconds LONGEST{ 300 };  // between warnings

  const std::string topic_;
  Clock::time_point last_content_ = Clock::now();
  std::chrono::seconds next_warning_ = FIRST;
};
}  // namespace devo_evo
