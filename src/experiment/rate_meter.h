#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <limits>

namespace devo_evo
{
/// How fast something has been happening of late. For people; no result depends on it.
class RateMeter
{
public:
  using Clock = std::chrono::steady_clock;

  /// @param window how far back to look; farther if fewer than two events lie within it.
  RateMeter(Clock::time_point start, Clock::duration window) : window_(window) { events_.push_back({ start, 0 }); }

  void add(Clock::time_point time, int64_t count)
  {
    events_.push_back({ time, count });
    total_ += count;
    while (events_.size() > 2 && events_[1].time < time - window_)
    {
      events_.pop_front();
      total_ -= events_.front().count;  // from now on it only marks the beginning
      events_.front().count = 0;
    }
  }

  /// [1/s]; NaN before the first event.
  double rate() const
  {
    const double elapsed_s = std::chrono::duration<double>(events_.back().time - events_.front().time).count();
    return elapsed_s > 0.0 ? static_cast<double>(total_) / elapsed_s : std::numeric_limits<double>::quiet_NaN();
  }

private:
  struct Event
  {
    Clock::time_point time;
    int64_t count;
  };

  const Clock::duration window_;
  std::deque<Event> events_;  ///< the first one marks the beginning
  int64_t total_ = 0;         ///< of all but the first
};
}  // namespace devo_evo
