#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "models/signals.h"

namespace touchdown::controller {

/// Where the flight stands. The transition table is in guidance.cc and docs/guidance.md.
enum class Phase {
  kStandby,       ///< On the ground, motors off.
  kBlindClimb,    ///< Open-loop climb until the circle is seen (Sec. VI-B.3).
  kRamp,          ///< The set-point's height rises at a constant rate (Sec. V).
  kHover,         ///< At the set-point.
  kLanding,       ///< The set-point steps down, each step when the vehicle stayed in the cone Q' (Sec. V).
  kBlindDescent,  ///< Below the blind height: constant rate, on prediction.
  kTouchdown,     ///< Motors off, on the ground or a hand's breadth from it.
  kHold,          ///< The pad is lost: stay at the last set-point, on prediction.
  kSearchClimb,   ///< Still lost: climb at a constant rate to see more of the ground.
  kGaveUp,        ///< Still lost: control is handed over. Ends the flight.
};

/// "standby", "blind_climb", "ramp", ...
std::string_view Name(Phase phase);

/// One step of what the vehicle is to do.
struct Manoeuvre {
  enum class Kind { kTakeoff, kHover, kLand };
  Kind kind = Kind::kHover;
  Eigen::Vector3d position_m{0.0, 0.0, 1.0};  ///< Takeoff (its height) and hover: the set-point in W.
  double duration_s = 0.0;                    ///< Hover only.
};

}  // namespace touchdown::controller
