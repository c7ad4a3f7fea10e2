#pragma once

#include <filesystem>

#include "scenarios/flight/fly.h"

namespace touchdown::scenarios {

/// Flies a scenario and leaves its folder at `place`: scenario.yaml, result.json, the tables, timing.json,
/// frames.png and report.html (docs/scenarios.md says what each holds; a flight without frames has no frames.png). The
/// folder appears when everything is written, see OutputFolder. Throws InputError for a place that cannot be used,
/// before the flight, and as Fly does.
FlightResult FlyIntoFolder(const Scenario& scenario, const std::filesystem::path& place, FlightObservers observers = {},
                           const StopRequested& stop_requested = nullptr);

}  // namespace touchdown::scenarios
