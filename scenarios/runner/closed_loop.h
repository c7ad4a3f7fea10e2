#pragma once

#include "scenarios/runner/flight_audience.h"
#include "scenarios/runner/flight_log.h"
#include "scenarios/runner/scenario.h"
#include "scenarios/util/interrupted.h"

namespace touchdown::runner {

/// Flies a scenario from start to end: world -> sensors -> estimator -> filter -> guidance -> controller -> mixer ->
/// world. A simulation that goes wrong ends the log with outcome `error`. Throws InputError for a scenario that cannot
/// be set up, Interrupted, and what an observer throws. `stop_requested` may be null.
FlightLog FlyClosedLoop(const Scenario& scenario, FlightObservers observers, const util::StopRequested& stop_requested);

}  // namespace touchdown::runner
