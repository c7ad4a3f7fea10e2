#include "controller/transition_table.h"

namespace touchdown::controller {
namespace {

using enum Phase;
using Kind = ManeuverKind;

constexpr std::array<std::string_view, kPhaseCount> kNames{"standby",      "blind_climb",   "ramp",      "hover",
                                                           "landing",      "blind_descent", "touchdown", "hold",
                                                           "search_climb", "gave_up"};

constexpr Transition kTable[] = {
    {kStandby, [](const Conditions& c, bool time_is_up) { return c.task == Kind::kTakeoff && time_is_up; },
     kBlindClimb},

    {kBlindClimb, [](const Conditions& c, bool) { return c.pad_found; }, kRamp},
    {kBlindClimb, [](const Conditions& c, bool) { return c.high_enough; }, kHold},
    {kBlindClimb, [](const Conditions&, bool time_is_up) { return time_is_up; }, kHold},

    {kRamp, [](const Conditions& c, bool) { return c.pad_lost; }, kHold},
    {kRamp, [](const Conditions& c, bool) { return c.arrived; }, kHover},
    {kRamp, [](const Conditions&, bool time_is_up) { return time_is_up; }, kGaveUp},

    {kHover, [](const Conditions& c, bool) { return c.pad_lost; }, kHold},
    {kHover, [](const Conditions& c, bool) { return c.task == Kind::kLand; }, kLanding},

    {kLanding, [](const Conditions& c, bool) { return c.pad_lost; }, kHold},
    {kLanding, [](const Conditions& c, bool) { return c.ready_for_blind_descent; }, kBlindDescent},
    {kLanding, [](const Conditions&, bool time_is_up) { return time_is_up; }, kGaveUp},

    {kBlindDescent, [](const Conditions& c, bool) { return c.low_enough; }, kTouchdown},
    {kBlindDescent, [](const Conditions&, bool time_is_up) { return time_is_up; }, kTouchdown},

    {kHold, [](const Conditions& c, bool) { return c.pad_found && c.task == Kind::kTakeoff; }, kRamp},
    {kHold, [](const Conditions& c, bool) { return c.pad_found && c.task == Kind::kLand; }, kLanding},
    {kHold, [](const Conditions& c, bool) { return c.pad_found; }, kHover},
    {kHold, [](const Conditions&, bool time_is_up) { return time_is_up; }, kSearchClimb},

    {kSearchClimb, [](const Conditions& c, bool) { return c.pad_found && c.task == Kind::kTakeoff; }, kRamp},
    {kSearchClimb, [](const Conditions& c, bool) { return c.pad_found && c.task == Kind::kLand; }, kLanding},
    {kSearchClimb, [](const Conditions& c, bool) { return c.pad_found; }, kHover},
    {kSearchClimb, [](const Conditions& c, bool) { return c.high_enough; }, kGaveUp},
    {kSearchClimb, [](const Conditions&, bool time_is_up) { return time_is_up; }, kGaveUp},
};

}  // namespace

std::string_view Name(Phase phase) { return kNames[static_cast<std::size_t>(phase)]; }

std::span<const Transition> TransitionTable() { return kTable; }

Phase NextPhase(Phase phase, const Conditions& conditions, models::Tick ticks_in_phase, const PhaseLimits& limits) {
  const std::optional<models::Tick> limit = limits[static_cast<std::size_t>(phase)];
  const bool time_is_up = limit.has_value() && ticks_in_phase >= *limit;
  for (const Transition& row : kTable) {
    if (row.from == phase && row.holds(conditions, time_is_up)) return row.to;
  }
  return phase;
}

}  // namespace touchdown::controller
