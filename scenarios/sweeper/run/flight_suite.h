#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "scenarios/sweeper/plan/flight_row.h"
#include "scenarios/util/interrupted.h"

namespace touchdown::sweeper {

/// Result of a scenario that was flown as a test.
struct TestedFlight {
  std::filesystem::path file;
  runner::Scenario scenario;
  FlightRow row;
  std::vector<runner::Check> checks;  ///< Checks of the outcome and of the criteria.
};

/// Flies every scenario (*.yaml) in a folder, without subfolders, at most `jobs` concurrently, each in its own process.
/// Calls `on_done` when a flight is done. Returns the results in the order of the file names. Throws InputError, before
/// any flight, if there is no scenario or an invalid one, and Interrupted if a stop was requested.
std::vector<TestedFlight> TestFlights(const std::filesystem::path& folder, int jobs,
                                      const util::StopRequested& stop_requested,
                                      const std::function<void(const TestedFlight&)>& on_done);

}  // namespace touchdown::sweeper
