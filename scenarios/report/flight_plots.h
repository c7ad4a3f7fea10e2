#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "scenarios/report/flight_series.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::report {

/// First ground contact of the landing: time and position of the body origin in W, from the metrics of the flight.
struct Touchdown {
  double t_s = 0.0;
  double x_m = 0.0;
  double y_m = 0.0;
};

/// Returns the plot data of the report page as JSON, for the scripts in scenarios/report/web/: phases, events,
/// touchdown, plots, ground track and pad. Series are thinned to the resolution of a screen (ThinnedRows). Values have
/// five significant digits. `touchdown` is nullopt when the vehicle did not touch down.
nlohmann::ordered_json FlightPlots(const FlightSeries& flight, const std::optional<Touchdown>& touchdown,
                                   const runner::Scenario& scenario);

}  // namespace touchdown::report
