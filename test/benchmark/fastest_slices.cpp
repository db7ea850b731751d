#include "benchmark/fastest_slices.h"

#include <time.h>

#include <algorithm>
#include <numeric>

namespace devo_evo
{
namespace
{
/// CPU time of this thread [s].
double threadTime()
{
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}
}  // namespace

void FastestSlices::begin()
{
  next_ = 0;
  begin_ = since_ = threadTime();
}

void FastestSlices::endSlice()
{
  const double now = threadTime();
  if (next_ == seconds_.size())
  {
    seconds_.push_back(now - since_);
  }
  seconds_[next_] = std::min(seconds_[next_], now - since_);
  ++next_;
  since_ = now;
}

double FastestSlices::sum() const
{
  return std::accumulate(seconds_.begin(), seconds_.end(), 0.0);
}

double FastestSlices::whole() const
{
  return since_ - begin_;
}
}  // namespace devo_evo
