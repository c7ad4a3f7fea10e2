#pragma once

#include <cstdint>

#include "models/describe.h"

namespace touchdown::models {

/// Simulated time as a count of physics ticks since the start of the flight. There is no other clock
/// inside the loop.
using Tick = std::int64_t;

/// The length of a tick. Every periodic source fires on the ticks that its period divides.
struct TimeBase {
  int ticks_per_s = 1200;

  double period_s() const { return 1.0 / ticks_per_s; }
  double ToSeconds(Tick tick) const { return static_cast<double>(tick) / ticks_per_s; }

  /// The tick nearest to `time_s`, which may be negative; at most 1e15 from 0, which stands for never.
  Tick FromSeconds(double time_s) const;

  /// Whole nanoseconds, as recordings count time, and back: each the nearest. A tick read back is the same tick.
  std::int64_t ToNanoseconds(Tick tick) const;
  Tick FromNanoseconds(std::int64_t time_ns) const;

  /// Ticks between two events of a source that fires at `rate_hz`. Throws InputError when the rate is not
  /// positive or does not divide `ticks_per_s`.
  Tick PeriodOf(int rate_hz) const;
};

/// The range of a periodic source's rate, beside TimeBase::PeriodOf.
inline constexpr Range kRate_hz = Between(1, 100000);

void Describe(ConfigVisitor& v, TimeBase& time);

}  // namespace touchdown::models
