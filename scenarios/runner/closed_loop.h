#pragma once

#include "scenarios/runner/flight_audience.h"
#include "scenarios/runner/flight_log.h"
#include "scenarios/runner/scenario.h"
#include "scenarios/util/interrupted.h"

namespace touchdown::runner {

/// Flies a scenario in closed loop: world -> sensors -> estimator -> filter -> guidance -> controller -> mixer ->
/// world. A failure of the simulation ends the log with outcome `error`. Throws InputError for a scenario that cannot
/// be set up and Interrupted when a stop is requested; exceptions of observers propagate. `stop_requested` may be
/// null.
FlightLog FlyClosedLoop(const Scenario& scenario, FlightObservers observers, const util::StopRequested& stop_requested);

}  // namespace touchdown::runner
