#pragma once

#include <filesystem>

#include "scenarios/flight/fly.h"

namespace touchdown::scenarios {

/// What a flight's folder holds only when asked for.
struct FlightExtras {
  bool video = true;  ///< flight.mp4.
};

/// Flies a scenario and leaves its folder at `place`: scenario.yaml, result.json, the tables, timing.json,
/// frames.png and `extras` (docs/scenarios.md says what each holds; a flight without frames has no pictures). The
/// folder appears when everything is written, see OutputFolder. Throws InputError for a place that cannot be used,
/// before the flight, and as Fly does.
FlightResult FlyIntoFolder(const Scenario& scenario, const std::filesystem::path& place,
                           const FlightExtras& extras = {}, FlightObservers observers = {},
                           const StopRequested& stop_requested = nullptr);

}  // namespace touchdown::scenarios
