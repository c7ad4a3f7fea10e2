#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "models/time.h"

namespace touchdown::controller {

/// Phase of the flight. docs/guidance.md draws the transitions.
enum class Phase {
  kStandby,       ///< On the ground, motors off.
  kBlindClimb,    ///< Open-loop climb until the ring is detected (Sec. VI-B.3).
  kRamp,          ///< The set-point's height rises at a constant rate (Sec. V).
  kHover,         ///< At the set-point.
  kLanding,       ///< The set-point steps down, each step when the vehicle stayed in the cone Q' (Sec. V).
  kBlindDescent,  ///< Below the blind height: descent at a constant rate, with predicted motion.
  kTouchdown,     ///< Motors off, on the ground or just above it.
  kHold,          ///< The pad is lost: stay at the last set-point, with predicted motion.
  kSearchClimb,   ///< Still lost: climb at a constant rate to see more of the ground.
  kGaveUp,        ///< Still lost: control is handed over. Ends the flight.
};
inline constexpr int kPhaseCount = 10;

/// "standby", "blind_climb", "ramp", "hover", "landing", "blind_descent", "touchdown", "hold", "search_climb",
/// "gave_up".
std::string_view Name(Phase phase);

enum class ManeuverKind { kTakeoff, kHover, kLand };

/// Conditions of the transitions, apart from time.
struct Conditions {
  std::optional<ManeuverKind> task = std::nullopt;  ///< Current maneuver of the script; nullopt: all are complete.
  bool pad_lost = false;                            ///< Not detected for pad_lost_s, or never.
  bool pad_found = false;                           ///< Detected for pad_found_s without being lost.
  bool arrived = false;                  ///< The set-point of the ramp has stopped and the vehicle has reached it.
  bool ready_for_blind_descent = false;  ///< At the blind height and in Q' for t_0, and slow.
  bool low_enough = false;               ///< The predicted height is at or below h_land.
  bool high_enough = false;              ///< The predicted climb has reached its limit.
};

/// Longest duration of each phase, ticks; nullopt: unlimited.
using PhaseLimits = std::array<std::optional<models::Tick>, kPhaseCount>;

/// One row: transition from `from` to `to` when `holds` is true.
struct Transition {
  Phase from;
  bool (*holds)(const Conditions& conditions, bool time_is_up);
  Phase to;
};

/// All rows, in order of precedence within a phase.
std::span<const Transition> TransitionTable();

/// Next phase after `ticks_in_phase` in `phase`: that of the first matching row, else `phase`. Pure function.
Phase NextPhase(Phase phase, const Conditions& conditions, models::Tick ticks_in_phase, const PhaseLimits& limits);

}  // namespace touchdown::controller
