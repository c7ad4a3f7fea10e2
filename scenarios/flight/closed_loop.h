#pragma once

#include <functional>

#include "estimator/estimator.h"
#include "models/signals.h"
#include "scenarios/flight/flight_log.h"
#include "scenarios/flight/interrupted.h"
#include "scenarios/flight/scenario.h"

namespace touchdown::scenarios {

/// Sees every delivered frame with what the estimator made of it: for pictures.
using FrameObserver =
    std::function<void(const models::CameraFrame&, const estimator::FrameEstimate&, const FrameRecord&)>;

/// Flies a scenario from start to end: world -> sensors -> estimator -> filter -> guidance -> controller -> mixer ->
/// world. A simulation that goes wrong ends the log with outcome `error`. Throws InputError for a scenario that cannot
/// be set up, and Interrupted. Both callbacks may be null.
FlightLog FlyClosedLoop(const Scenario& scenario, const FrameObserver& on_frame, const StopRequested& stop_requested);

}  // namespace touchdown::scenarios
