#pragma once

#include <optional>
#include <string>

#include "controller/flight_controller.h"
#include "scenarios/runner/scenario.h"
#include "sim/dynamics/true_state.h"

namespace touchdown::runner {

/// Outcome of a flight and a short reason.
struct Ending {
  Outcome outcome = Outcome::kError;
  std::string reason;
};

/// Detects the end of a flight.
class EndWatch {
 public:
  explicit EndWatch(const Scenario& scenario);

  /// Returns the ending, or nullopt while the flight continues. Call once per tick, in order, with the newest control
  /// output.
  std::optional<Ending> Judge(const sim::TrueState& truth, const controller::ControlOutput& control);

 private:
  std::optional<Ending> JudgeDanger(const sim::TrueState& truth) const;
  std::optional<Ending> JudgeScript(const sim::TrueState& truth, const controller::ControlOutput& control);
  std::optional<Ending> JudgeRest(const sim::TrueState& truth);

  models::TimeBase time_;
  std::optional<models::Tick> hand_held_end_;
  models::Tick time_limit_;
  double half_width_m_;
  double ceiling_m_;
  std::optional<models::Tick> motors_off_;  ///< Tick at which the motors stopped after a landing.
  std::optional<models::Tick> at_rest_;     ///< Tick since which the vehicle has been at rest after motors_off_.
};

}  // namespace touchdown::runner
