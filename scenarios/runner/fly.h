#pragma once

#include <string>
#include <vector>

#include "scenarios/runner/closed_loop.h"
#include "scenarios/runner/flight_log.h"
#include "scenarios/runner/metrics.h"
#include "scenarios/runner/scenario.h"
#include "scenarios/runner/verdict.h"
#include "scenarios/util/interrupted.h"

namespace touchdown::runner {

/// Wall-clock times of a flight.
struct Timing {
  double vision_ms_mean = 0.0;
  double vision_ms_p99 = 0.0;
  double render_ms_mean = 0.0;
  double realtime_factor = 0.0;  ///< Simulated time divided by wall-clock time.
};

/// Verdict of a flight with its metrics and checks.
struct FlightResult {
  Verdict verdict = Verdict::kError;
  Outcome outcome = Outcome::kError;
  std::string reason;
  Metrics metrics;
  std::vector<Check> checks;
  Timing timing;
  std::string log_sha256;  ///< See LogDigest.
};

/// Evaluates a flight: computes its metrics, checks and verdict. Does not write tables.
FlightResult JudgeFlight(const Scenario& scenario, const FlightLog& log);

/// Flies a scenario and evaluates the flight. Writes no file. Throws like FlyClosedLoop.
FlightResult Fly(const Scenario& scenario, FlightObservers observers = {},
                 const util::StopRequested& stop_requested = nullptr);

/// Text of result.json and timing.json.
std::string ResultJson(const Scenario& scenario, const FlightResult& result);
std::string TimingJson(const Timing& timing);

}  // namespace touchdown::runner
