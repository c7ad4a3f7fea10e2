#include "scenarios/runner/events/gust.h"

#include <fmt/format.h>

#include <cmath>

#include "models/angles.h"
#include "models/error.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::runner {

void Gust::Describe(models::ConfigVisitor& v) {
  v.Vector3({"peak_velocity_m_s", "Peak velocity of the gust in W (gust only).", true}, peak_velocity_m_s,
            models::kMeterPerSecond, models::Between(-50.0, 50.0));
}

void Gust::Check(const Scenario& scenario, double duration_s) const {
  if (peak_velocity_m_s.isZero(0.0)) throw InputError("a gust needs a peak_velocity_m_s other than 0");
  if (duration_s < 2.0 * scenario.time.period_s()) throw InputError("lasts less than two ticks of the clock");
}

std::string Gust::Label() const { return fmt::format("gust {:.3g} m/s", peak_velocity_m_s.norm()); }

void Gust::Apply(const EventTime& time, EventEffects& effects) const {
  const double phase = 2.0 * models::kPi * time.elapsed_s / time.duration_s;
  effects.gust_m_s += 0.5 * (1.0 - std::cos(phase)) * peak_velocity_m_s;
}

}  // namespace touchdown::runner
