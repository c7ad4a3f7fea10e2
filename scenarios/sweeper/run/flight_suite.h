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
  std::vector<runner::Check> checks;  ///< Empty for a flight that did not end.
};

/// Flies every scenario (*.yaml) of a folder, without subfolders, at most `jobs` concurrently, each in its own process,
/// and reports each when it is done. Returns the results by file name. Throws InputError, before any flight, when there
/// is no scenario or an invalid one, and Interrupted when a stop was requested.
std::vector<TestedFlight> TestFlights(const std::filesystem::path& folder, int jobs,
                                      const util::StopRequested& stop_requested,
                                      const std::function<void(const TestedFlight&)>& on_done);

}  // namespace touchdown::sweeper
