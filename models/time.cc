#include "models/time.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "models/error.h"

namespace touchdown::models {

Tick TimeBase::FromSeconds(double time_s) const {
  constexpr double kFarthest = 1e15;  // Ticks: beyond every flight, and sums of a few still fit.
  return std::llround(std::clamp(time_s * ticks_per_s, -kFarthest, kFarthest));
}

Tick TimeBase::PeriodOf(int rate_hz) const {
  if (rate_hz <= 0 || ticks_per_s % rate_hz != 0) {
    throw InputError("a rate of " + std::to_string(rate_hz) + " Hz does not divide the " + std::to_string(ticks_per_s) +
                     " physics ticks of a second");
  }
  return ticks_per_s / rate_hz;
}

}  // namespace touchdown::models
