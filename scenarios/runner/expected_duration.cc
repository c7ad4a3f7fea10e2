#include "scenarios/runner/expected_duration.h"

#include <algorithm>

namespace touchdown::runner {
namespace {

using controller::GuidanceConfig;
using controller::Maneuver;
using controller::ManeuverKind;

double Takeoff_s(const GuidanceConfig& c, double height_m) {
  const double thrust_rise_s = (1.0 - c.start_thrust_ratio) / c.thrust_ratio_rate_1_s;
  return c.standby_s + thrust_rise_s + height_m / c.climb_rate_m_s;
}

double Landing_s(const GuidanceConfig& c, double height_m) {
  constexpr double kSettlingFactor = 1.3;  // Each step waits until the vehicle is in the cone.
  const double blind_s = (c.blind_clearance_m - c.h_land_clearance_m) / c.blind_descent_rate_m_s;
  return kSettlingFactor * height_m / c.step_rate_m_s + blind_s;
}

}  // namespace

double ExpectedDuration_s(const Scenario& scenario) {
  if (scenario.hand.carries) return sim::Hand::kTimeAtRest_s + scenario.hand.duration_s;
  const GuidanceConfig& guidance = scenario.controller.guidance;
  constexpr double kTransfer_m_s = 0.5;
  double duration_s = 0.0;
  Eigen::Vector3d position_m = scenario.start.airborne ? scenario.start.position_m : Eigen::Vector3d::Zero();
  for (const Maneuver& maneuver : scenario.script) {
    switch (maneuver.kind) {
      case ManeuverKind::kTakeoff:
        duration_s += Takeoff_s(guidance, maneuver.position_m.z());
        break;
      case ManeuverKind::kHover:
        duration_s += (maneuver.position_m - position_m).norm() / kTransfer_m_s + maneuver.duration_s;
        break;
      case ManeuverKind::kLand:
        duration_s += Landing_s(guidance, position_m.z());
        continue;
    }
    position_m = maneuver.position_m;
  }
  return std::min(duration_s, scenario.time_limit_s);
}

}  // namespace touchdown::runner
