#pragma once

#include <optional>
#include <string>

#include "controller/flight_controller.h"
#include "scenarios/runner/scenario.h"
#include "sim/dynamics/true_state.h"

namespace touchdown::runner {

/// How a flight ended, and why in a few words.
struct Ending {
  Outcome outcome = Outcome::kError;
  std::string reason;
};

/// Sees when a flight is over.
class EndWatch {
 public:
  explicit EndWatch(const Scenario& scenario);

  /// Call it once a tick, in order, with the newest control output; nullopt while the flight goes on.
  std::optional<Ending> Judge(const sim::TrueState& truth, const controller::ControlOutput& control);

 private:
  std::optional<Ending> JudgeDanger(const sim::TrueState& truth) const;
  std::optional<Ending> JudgeScript(const sim::TrueState& truth, const controller::ControlOutput& control);
  std::optional<Ending> JudgeRest(const sim::TrueState& truth);

  models::TimeBase time_;
  std::optional<models::Tick> hand_ends_;
  models::Tick time_limit_;
  double half_room_m_;
  double ceiling_m_;
  std::optional<models::Tick> motors_off_;  ///< Since when the motors are off after a landing.
  std::optional<models::Tick> at_rest_;     ///< Since when the vehicle has been at rest since then.
};

}  // namespace touchdown::runner
