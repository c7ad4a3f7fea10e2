#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "models/time.h"

namespace touchdown::controller {

/// Where the flight stands. docs/guidance.md draws the transitions.
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
inline constexpr int kPhaseCount = 10;

/// "standby", "blind_climb", "ramp", "hover", "landing", "blind_descent", "touchdown", "hold", "search_climb",
/// "gave_up".
std::string_view Name(Phase phase);

enum class ManeuverKind { kTakeoff, kHover, kLand };

/// What the transitions depend on, beside the time.
struct Conditions {
  std::optional<ManeuverKind> task = std::nullopt;  ///< The maneuver that the script is at; nullopt: all are flown.
  bool pad_lost = false;                            ///< Not seen for pad_lost_s, or never.
  bool pad_found = false;                           ///< Seen for pad_found_s without being lost.
  bool arrived = false;                             ///< The ramp's set-point has stopped and the vehicle is there.
  bool ready_for_blind_descent = false;             ///< At the blind height, in Q', slow, for t_0.
  bool low_enough = false;                          ///< By prediction at or below h_land.
  bool high_enough = false;                         ///< By prediction at the height where a climb without the pad ends.
};

/// How long a phase may last, in ticks; nullopt: for ever. Indexed by phase.
using PhaseLimits = std::array<std::optional<models::Tick>, kPhaseCount>;

/// One row: in `from`, when `holds` says so, go to `to`.
struct Transition {
  Phase from;
  bool (*holds)(const Conditions& conditions, bool time_is_up);
  Phase to;
};

/// The whole table, in order of precedence within a phase.
std::span<const Transition> TransitionTable();

/// The phase that follows after `ticks_in_phase` in `phase`: that of the first row which holds, or `phase` itself.
/// Pure.
Phase NextPhase(Phase phase, const Conditions& conditions, models::Tick ticks_in_phase, const PhaseLimits& limits);

}  // namespace touchdown::controller
