#include "cli/progress_display.h"

#include <algorithm>
#include <iostream>

#include <sys/ioctl.h>
#include <unistd.h>

namespace devo_evo
{
namespace
{
/// How much of a line fits the terminal: one that wraps could not be overwritten.
size_t terminalWidth()
{
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : std::string::npos;
}
}  // namespace

ProgressDisplay::ProgressDisplay() : live_(isatty(STDERR_FILENO) == 1)
{
}

void ProgressDisplay::show(const std::string& line, bool important)
{
  const auto now = Clock::now();
  if (now < next_ && !important)
  {
    return;
  }
  if (live_)
  {
    std::cerr << "\r" << line.substr(0, terminalWidth()) << "\x1b[K" << std::flush;
    line_open_ = true;
    next_ = now + std::chrono::milliseconds(100);
    return;
  }
  std::cerr << line << std::endl;
  const Clock::duration shortest = std::chrono::seconds(1), longest = std::chrono::minutes(1);
  next_ = now + std::clamp((now - start_) / 50, shortest, longest);
}

void ProgressDisplay::end()
{
  if (line_open_)
  {
    std::cerr << std::endl;
    line_open_ = false;
  }
}
}  // namespace devo_evo
