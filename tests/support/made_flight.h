#pragma once

#include "scenarios/report/flight_files.h"
#include "scenarios/runner/flight_log.h"

namespace touchdown::tests {

/// A flight of `duration_s` made up without simulation: a blind climb, a hover with a swing along X, and a landing with
/// its touchdown in the last tenth; vision sees the pad in the hover.
runner::FlightLog MadeFlight(const runner::Scenario& scenario, double duration_s);

/// The files that such a flight leaves.
report::FlightFiles FilesOf(const runner::Scenario& scenario, const runner::FlightLog& log);

}  // namespace touchdown::tests
