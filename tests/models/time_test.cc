#include "models/time.h"

#include <gtest/gtest.h>

#include "models/error.h"

namespace touchdown::models {
namespace {

TEST(TimeBase, Has1200TicksPerSecondByDefault) {
  const TimeBase time;
  EXPECT_EQ(time.FromSeconds(1.0), 1200);
  EXPECT_EQ(time.ToSeconds(600), 0.5);
  EXPECT_EQ(time.period_s(), 1.0 / 1200.0);
}

TEST(TimeBase, RoundsToTheNearestTickOnBothSidesOfZero) {
  const TimeBase time;
  EXPECT_EQ(time.FromSeconds(0.0040), 5);
  EXPECT_EQ(time.FromSeconds(-0.0040), -5);
  EXPECT_EQ(time.FromSeconds(0.4 / 1200.0), 0);
  EXPECT_EQ(time.FromSeconds(-0.6 / 1200.0), -1);
}

TEST(TimeBase, RoundTripsTicksThroughSeconds) {
  for (const int ticks_per_s : {100, 1000, 1200, 44100}) {
    const TimeBase time{.ticks_per_s = ticks_per_s};
    for (Tick tick = -50000; tick < 5000000; tick += 997) ASSERT_EQ(time.FromSeconds(time.ToSeconds(tick)), tick);
  }
}

TEST(TimeBase, ClampsVeryLargeTimes) {
  const TimeBase time;
  EXPECT_EQ(time.FromSeconds(1e300), 1'000'000'000'000'000);
  EXPECT_EQ(time.FromSeconds(-1e300), -1'000'000'000'000'000);
}

TEST(TimeBase, ComputesThePeriodsOfTheSensors) {
  const TimeBase time;
  EXPECT_EQ(time.PeriodOf(200), 6);
  EXPECT_EQ(time.PeriodOf(100), 12);
  EXPECT_EQ(time.PeriodOf(60), 20);
  EXPECT_EQ(time.PeriodOf(1200), 1);
}

TEST(TimeBase, RejectsARateThatDoesNotDivideTheTicks) {
  const TimeBase time;
  for (const int rate_hz : {0, -60, 7, 90, 2400}) EXPECT_THROW(time.PeriodOf(rate_hz), InputError) << rate_hz;
}

TEST(TimeBase, RoundTripsTicksThroughNanoseconds) {
  const TimeBase time;
  EXPECT_EQ(time.ToNanoseconds(1), 833333);
  EXPECT_EQ(time.ToNanoseconds(1200), 1'000'000'000);
  EXPECT_EQ(time.ToNanoseconds(-20), -16666667);
  for (const Tick tick : {-2400, -1, 0, 7, 20, 123456789}) {
    EXPECT_EQ(time.FromNanoseconds(time.ToNanoseconds(tick)), tick);
  }
  const TimeBase microseconds{.ticks_per_s = 1'000'000};
  EXPECT_EQ(microseconds.FromNanoseconds(1403636579763555584), 1403636579763556);
  EXPECT_EQ(microseconds.ToNanoseconds(1403636579763556), 1403636579763556000);
}

}  // namespace
}  // namespace touchdown::models
