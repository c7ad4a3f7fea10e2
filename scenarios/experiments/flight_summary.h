#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/experiments/measurement.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::experiments {

/// The scenario `name` of scenarios/flights, as embedded at build time, with the given seed and overrides
/// ("KEY=VALUE"). Throws std::logic_error for an unknown name.
runner::Scenario ShippedFlight(const std::string& name, std::uint64_t seed, const std::vector<std::string>& set = {});

/// Optional entries of a flight summary.
struct FlightSummaryOptions {
  bool integer_contours = false;  ///< Adds the errors with integer contour points, on the same frames.
  bool unverified = false;        ///< Adds the results with `verify: none`, on the same frames.
  bool series = false;            ///< Adds the time series of the flight.
};

/// Flies a scenario and summarizes the flight: outcome, whether it passed, errors of the vision poses as in Table I (mm
/// and deg) relative to the truth and to the tracking system, availability, false pads, and the rest pose after a
/// landing. Undefined values are omitted. Throws std::runtime_error when the simulation fails, and as
/// runner::FlyClosedLoop() does.
Json FlyAndSummarize(const runner::Scenario& scenario, const FlightSummaryOptions& options,
                     const util::StopRequested& stop_requested);

}  // namespace touchdown::experiments
