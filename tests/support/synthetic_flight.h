#pragma once

#include "scenarios/report/flight_files.h"
#include "scenarios/runner/flight_log.h"

namespace touchdown::tests {

/// Log of a flight of `duration_s` without simulation: a blind climb, a hover with an oscillation along X, and a
/// landing whose touchdown is in the last tenth. Vision detects the pad in the hover.
runner::FlightLog SyntheticFlight(const runner::Scenario& scenario, double duration_s);

/// Files of the flight directory.
report::FlightFiles FilesOf(const runner::Scenario& scenario, const runner::FlightLog& log);

}  // namespace touchdown::tests
