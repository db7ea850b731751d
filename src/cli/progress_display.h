#pragma once

#include <chrono>
#include <string>

namespace devo_evo
{
/// Progress for people, on standard error: on a terminal one line that is kept up to date; elsewhere lines, ever fewer
/// of them a minute the longer it takes, so that a log of days stays short.
class ProgressDisplay
{
public:
  ProgressDisplay();
  ~ProgressDisplay() { end(); }
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// @param important whether the line must not be left out.
  void show(const std::string& line, bool important);

  /// Ends the live line.
  void end();

private:
  using Clock = std::chrono::steady_clock;

  const bool live_;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_;
  bool line_open_ = false;
};
}  // namespace devo_evo
