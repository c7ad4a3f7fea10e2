#pragma once

#include <cstdint>

#include "models/describe.h"

namespace touchdown::models {

/// Simulated time as a count of physics ticks since the start of the flight. The loop uses no other clock.
using Tick = std::int64_t;

/// Length of a tick. A periodic source fires on the ticks that are multiples of its period.
struct TimeBase {
  int ticks_per_s = 1200;

  double period_s() const { return 1.0 / ticks_per_s; }
  double ToSeconds(Tick tick) const { return static_cast<double>(tick) / ticks_per_s; }

  /// Tick nearest to `time_s`, which may be negative. The result is clamped to +-1e15, which means never.
  Tick FromSeconds(double time_s) const;

  /// Converts a tick to whole nanoseconds, the unit of time in recordings, and back, rounding to the nearest. The round
  /// trip of a tick is exact.
  std::int64_t ToNanoseconds(Tick tick) const;
  Tick FromNanoseconds(std::int64_t time_ns) const;

  /// Ticks between two events of a source that fires at `rate_hz`. Throws InputError when the rate is not
  /// positive or does not divide `ticks_per_s`.
  Tick PeriodOf(int rate_hz) const;
};

/// Range of a periodic source's rate. TimeBase::PeriodOf checks in addition that the rate divides the ticks.
inline constexpr Range kRate_hz = Between(1, 100000);

void Describe(ConfigVisitor& v, TimeBase& time);

}  // namespace touchdown::models
