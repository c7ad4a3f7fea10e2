#pragma once

#include "scenarios/flight/flight_audience.h"
#include "scenarios/flight/flight_log.h"
#include "scenarios/flight/interrupted.h"
#include "scenarios/flight/scenario.h"

namespace touchdown::scenarios {

/// Flies a scenario from start to end: world -> sensors -> estimator -> filter -> guidance -> controller -> mixer ->
/// world. A simulation that goes wrong ends the log with outcome `error`. Throws InputError for a scenario that cannot
/// be set up, Interrupted, and what an observer throws. `stop_requested` may be null.
FlightLog FlyClosedLoop(const Scenario& scenario, FlightObservers observers, const StopRequested& stop_requested);

}  // namespace touchdown::scenarios
