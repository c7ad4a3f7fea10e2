#pragma once

#include <filesystem>

#include "scenarios/runner/fly.h"

namespace touchdown::cli {

/// Optional files of a flight directory.
struct FlightExtras {
  bool video = true;       ///< Writes the video flight.mp4.
  bool recording = false;  ///< Writes frames, IMU and truth to the subfolder `recording`, see FlightRecording.
  bool bag = false;        ///< Writes the ROS bag flight.bag, see FlightBag.
};

/// Flies a scenario and writes its flight directory to `place`: scenario.yaml, result.json, the tables, timing.json,
/// frames.png, report.html and `extras`. docs/scenarios.md describes the files. frames.png is missing when the flight
/// has no frames. The directory appears once all files are written, see OutputFolder.
///
/// Throws InputError before the flight when `place` cannot be used, and otherwise as runner::FlyClosedLoop() does.
runner::FlightResult FlyIntoFolder(const runner::Scenario& scenario, const std::filesystem::path& place,
                                   const FlightExtras& extras = {}, runner::FlightObservers observers = {},
                                   const util::StopRequested& stop_requested = nullptr);

}  // namespace touchdown::cli
