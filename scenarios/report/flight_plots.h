#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "scenarios/report/flight_series.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::report {

/// The first contact of a landing: its time and the place of the body's origin in W, as the flight's metrics give it.
struct Touchdown {
  double t_s = 0.0;
  double x_m = 0.0;
  double y_m = 0.0;
};

/// A flight as its page draws it (scenarios/report/web/ reads it): phases, events and touchdown, the plots with their
/// series thinned to what a screen can show, and the ground track. Values have five significant digits.
nlohmann::ordered_json FlightPlots(const FlightSeries& flight, const std::optional<Touchdown>& touchdown,
                                   const runner::Scenario& scenario);

}  // namespace touchdown::report
