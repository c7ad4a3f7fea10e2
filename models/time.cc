#include "models/time.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "models/error.h"

namespace touchdown::models {

Tick TimeBase::FromSeconds(double time_s) const {
  constexpr double kFarthest = 1e15;  // In ticks: longer than any flight, and sums of a few values do not overflow.
  return std::llround(std::clamp(time_s * ticks_per_s, -kFarthest, kFarthest));
}

namespace {

/// value * factor / divisor, rounded to nearest, without intermediate overflow. `factor` and `divisor` are positive.
std::int64_t Scaled(std::int64_t value, std::int64_t factor, std::int64_t divisor) {
  const std::int64_t whole = value / divisor, rest = value % divisor;
  return whole * factor +
         std::llround(static_cast<double>(rest) * static_cast<double>(factor) / static_cast<double>(divisor));
}

constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;

}  // namespace

std::int64_t TimeBase::ToNanoseconds(Tick tick) const { return Scaled(tick, kNanosecondsPerSecond, ticks_per_s); }

Tick TimeBase::FromNanoseconds(std::int64_t time_ns) const {
  return Scaled(time_ns, ticks_per_s, kNanosecondsPerSecond);
}

Tick TimeBase::PeriodOf(int rate_hz) const {
  if (rate_hz <= 0 || ticks_per_s % rate_hz != 0) {
    throw InputError("a rate of " + std::to_string(rate_hz) + " Hz does not divide the " + std::to_string(ticks_per_s) +
                     " physics ticks per second");
  }
  return ticks_per_s / rate_hz;
}

void Describe(ConfigVisitor& v, TimeBase& time) {
  v.Integer({"ticks_per_s",
             "Physics steps per second. A larger value is more accurate and slower; every sensor rate must "
             "divide it."},
            time.ticks_per_s, Between(100, 100000));
}

}  // namespace touchdown::models
