#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

namespace devo_evo
{
/// How long batches have taken of late, on all workers: what a late one is held against.
class BatchTimes
{
public:
  using Seconds = std::chrono::duration<double>;

  void add(Seconds time)
  {
    times_.push_back(time);
    if (times_.size() > MOST)
    {
      times_.pop_front();
    }
  }

  /// The median; nothing before the first.
  std::optional<Seconds> usual() const
  {
    if (times_.empty())
    {
      return std::nullopt;
    }
    std::vector<Seconds> times(times_.begin(), times_.end());
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end());
    return *middle;
  }

private:
  static constexpr size_t MOST = 63;

  std::deque<Seconds> times_;
};
}  // namespace devo_evo
