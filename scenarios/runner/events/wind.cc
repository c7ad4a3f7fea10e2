#include "scenarios/runner/events/wind.h"

#include <fmt/format.h>

namespace touchdown::runner {

void Wind::Describe(models::ConfigVisitor& v) {
  v.Vector3({"velocity_m_s", "Mean wind in W from then on (wind only).", true}, velocity_m_s, models::kMeterPerSecond,
            models::Between(-50.0, 50.0));
}

std::string Wind::Label() const { return fmt::format("wind {:.3g} m/s", velocity_m_s.norm()); }

void Wind::Apply(const EventTime& time, EventEffects& effects) const {
  if (time.begins) effects.mean_wind_m_s = velocity_m_s;
}

}  // namespace touchdown::runner
