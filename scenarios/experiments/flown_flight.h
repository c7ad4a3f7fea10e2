#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/experiments/measurement.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::experiments {

/// The scenario of that name in scenarios/flights, as it was when the program was built.
runner::Scenario ShippedFlight(const std::string& name, std::uint64_t seed, const std::vector<std::string>& set = {});

struct FlightSummaryOptions {
  bool integer_contours = false;  ///< Also what whole pixels as contour points give, on the same frames.
  bool series = false;            ///< Also the flight over time.
};

/// Flies and sums up: outcome, whether it passed, the errors of vision's poses as in Table I (mm and deg, NaN-free:
/// what a flight does not have is left out) against the truth and against the tracking system, availability, false
/// pads, and where the vehicle came to rest.
Json FlyAndSumUp(const runner::Scenario& scenario, const FlightSummaryOptions& options,
                 const util::StopRequested& stop_requested);

}  // namespace touchdown::experiments
