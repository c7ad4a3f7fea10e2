#pragma once

#include "scenarios/flight/flight_log.h"
#include "scenarios/report/flight_files.h"

namespace touchdown::tests {

/// A flight of `duration_s` made up without simulation: a blind climb, a hover with a swing along X, and a landing with
/// its touchdown in the last tenth; vision sees the pad in the hover.
scenarios::FlightLog MadeFlight(const scenarios::Scenario& scenario, double duration_s);

/// The files that such a flight leaves.
scenarios::FlightFiles FilesOf(const scenarios::Scenario& scenario, const scenarios::FlightLog& log);

}  // namespace touchdown::tests
