#include "scenarios/runner/events/push.h"

#include <fmt/format.h>

#include "models/error.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::runner {

void Push::Describe(models::ConfigVisitor& v) {
  v.Vector3({"force_n", "Force in W at the body's origin (push only)."}, force_n, models::kNewton,
            models::Between(-1e3, 1e3));
  v.Vector3({"torque_n_m", "Torque in W (push only)."}, torque_n_m, {"Nm"}, models::Between(-1e3, 1e3));
}

void Push::Check(const Scenario& scenario, double duration_s) const {
  if (force_n.isZero(0.0) && torque_n_m.isZero(0.0)) {
    throw InputError("a push needs a force_n or a torque_n_m other than 0");
  }
  if (duration_s < scenario.time.period_s()) throw InputError("lasts less than a tick of the clock");
}

std::string Push::Label() const {
  return force_n.isZero() ? fmt::format("push {:.3g} N m", torque_n_m.norm())
                          : fmt::format("push {:.3g} N", force_n.norm());
}

void Push::Apply(const EventTime& /*time*/, EventEffects& effects) const {
  effects.force_n += force_n;
  effects.torque_n_m += torque_n_m;
}

}  // namespace touchdown::runner
