#pragma once

#include <nlohmann/json.hpp>

#include "scenarios/report/flight_series.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::report {

/// A flight as its page draws it (scenarios/report/web/ reads it): what happened when, the plots with their series
/// thinned to what a screen can show, and the track over the pad. Values have five significant digits.
nlohmann::ordered_json FlightPlots(const FlightSeries& flight, const runner::Scenario& scenario);

}  // namespace touchdown::report
