#include "experiment/rate_meter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace devo_evo
{
namespace
{
using std::chrono::seconds;

const RateMeter::Clock::time_point START{};

TEST(RateMeter, KnowsNothingBeforeTheFirstEvent)
{
  EXPECT_TRUE(std::isnan(RateMeter(START, seconds(10)).rate()));
}

TEST(RateMeter, CountsFromTheStart)
{
  RateMeter meter(START, seconds(10));
  meter.add(START + seconds(2), 8);
  EXPECT_DOUBLE_EQ(meter.rate(), 4.0);
  meter.add(START + seconds(4), 4);
  EXPECT_DOUBLE_EQ(meter.rate(), 3.0);
}

TEST(RateMeter, ForgetsWhatIsOlderThanTheWindow)
{
  RateMeter meter(START, seconds(10));
  meter.add(START + seconds(1), 1000);
  meter.add(START + seconds(20), 6);
  meter.add(START + seconds(25), 9);
  EXPECT_DOUBLE_EQ(meter.rate(), (6.0 + 9.0) / 24.0);  // since the last event before the window
}

TEST(RateMeter, LooksFartherBackWhereEventsAreRare)
{
  RateMeter meter(START, seconds(1));
  meter.add(START + seconds(100), 30);
  EXPECT_DOUBLE_EQ(meter.rate(), 0.3);
  meter.add(START + seconds(200), 40);
  EXPECT_DOUBLE_EQ(meter.rate(), 0.4);
}
}  // namespace
}  // namespace devo_evo
