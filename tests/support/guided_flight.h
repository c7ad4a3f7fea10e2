#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "controller/guidance.h"
#include "tests/support/nominal.h"

namespace touchdown::tests {

inline constexpr double kStanding_m = 0.14;
inline const controller::GuidanceConfig kConfig;
inline const double kBlindHeight_m = kStanding_m + kConfig.blind_clearance_m;

inline const controller::Maneuver kTakeoff{.kind = controller::ManeuverKind::kTakeoff, .position_m = {0.0, 0.0, 1.0}};
inline const controller::Maneuver kHover{
    .kind = controller::ManeuverKind::kHover, .position_m = {0.1, 0.2, 1.0}, .duration_s = 2.0};
inline const controller::Maneuver kLand{.kind = controller::ManeuverKind::kLand};

/// Guidance with a vehicle whose motion the test sets, one period at a time.
class GuidedFlight {
 public:
  GuidedFlight(std::vector<controller::Maneuver> script, bool airborne)
      : guidance_(kConfig, kTime, kPeriod_s, kStanding_m, std::move(script), airborne) {
    p = {0.0, 0.0, airborne ? 1.5 : kStanding_m};
  }

  Eigen::Vector3d p, v = Eigen::Vector3d::Zero();
  bool pad_lost = false, pad_found = true;
  bool follows = false;  ///< The vehicle is always at the set-point.
  controller::Guidance::Output output;
  double time_s = 0.0;

  const controller::Guidance::Output& Step() {
    output = guidance_.Update(
        {.tick = tick_, .motion = {.p_WB = p, .v_WB = v}, .pad_lost = pad_lost, .pad_found = pad_found});
    if (follows) p = output.p_m;
    tick_ += kTime.FromSeconds(kPeriod_s);
    time_s = kTime.ToSeconds(tick_);
    return output;
  }
  void Run(double duration_s) {
    for (int i = 0; i < std::lround(duration_s / kPeriod_s); ++i) Step();
  }
  bool RunUntil(controller::Phase phase, double limit_s) {
    for (int i = 0; i * kPeriod_s < limit_s; ++i) {
      if (Step().phase == phase) return true;
    }
    return false;
  }
  void LosePad() { pad_lost = true, pad_found = false; }
  void FindPad() { pad_lost = false, pad_found = true; }

 private:
  controller::Guidance guidance_;
  models::Tick tick_ = 0;
};

}  // namespace touchdown::tests
