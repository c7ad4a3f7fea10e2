#pragma once

#include <filesystem>

#include "scenarios/runner/fly.h"

namespace touchdown::cli {

/// What to leave of a flight beside its logs.
struct FlightExtras {
  bool video = true;       ///< flight.mp4.
  bool recording = false;  ///< Frames, IMU and truth in the folder `recording`, see FlightRecording.
  bool bag = false;        ///< The flight as a ROS bag, flight.bag, see FlightBag.
};

/// Flies a scenario and leaves its folder at `place`: scenario.yaml, result.json, the tables, timing.json and
/// frames.png, report.html (docs/scenarios.md says what each holds; a flight without frames has no pictures), and
/// `extras`. The
/// folder appears when everything is written, see OutputFolder. Throws InputError for a place that cannot be used,
/// before the flight, and as Fly does.
runner::FlightResult FlyIntoFolder(const runner::Scenario& scenario, const std::filesystem::path& place,
                                   const FlightExtras& extras = {}, runner::FlightObservers observers = {},
                                   const util::StopRequested& stop_requested = nullptr);

}  // namespace touchdown::cli
