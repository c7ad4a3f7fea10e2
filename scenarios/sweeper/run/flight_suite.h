#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "scenarios/sweeper/plan/flight_row.h"
#include "scenarios/util/interrupted.h"

namespace touchdown::sweeper {

/// A scenario that was flown as a test.
struct TestedFlight {
  std::filesystem::path file;
  runner::Scenario scenario;
  FlightRow row;
  std::vector<runner::Check> checks;  ///< Those of a flight that was not flown to its end are not kept.
};

/// Flies every scenario (*.yaml) of a folder, not of those in it, so many at a time, each in a process of its own, and
/// reports each when it is done. Throws InputError when there is none, or one is no valid scenario: then nothing is
/// flown; and Interrupted when a stop was requested. Returns them by their files' names.
std::vector<TestedFlight> TestFlights(const std::filesystem::path& folder, int jobs,
                                      const util::StopRequested& stop_requested,
                                      const std::function<void(const TestedFlight&)>& on_done);

}  // namespace touchdown::sweeper
