#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenarios/runner/closed_loop.h"
#include "scenarios/runner/flight_log.h"
#include "scenarios/runner/metrics.h"
#include "scenarios/runner/scenario.h"
#include "scenarios/runner/tum_trajectory.h"
#include "scenarios/util/interrupted.h"

namespace touchdown::runner {

enum class Verdict {
  kPass,   ///< Every check was kept.
  kFail,   ///< A check was not.
  kError,  ///< The simulation went wrong.
};
/// "pass", "fail" or "error".
std::string_view Name(Verdict verdict);

/// What the wall clock says of a flight.
struct Timing {
  double vision_ms_mean = 0.0;
  double vision_ms_p99 = 0.0;
  double render_ms_mean = 0.0;
  double realtime_factor = 0.0;  ///< Simulated over real time.
};

/// The logs' text, as the files of the same names hold it.
struct FlightTables {
  std::string flight_csv;
  std::string frames_csv;
  std::string tracking_csv;
  std::string frame_timing_csv;
  std::string truth_tum;
  std::string estimate_tum;
  std::string tracking_tum;
};

struct FlightResult {
  Verdict verdict = Verdict::kError;
  Outcome outcome = Outcome::kError;
  std::string reason;
  Metrics metrics;
  std::vector<Check> checks;
  Timing timing;
  std::string log_sha256;  ///< Of flight.csv followed by frames.csv.
  FlightTables tables;
  Trajectory truth;    ///< Of truth.tum.
  Trajectory tracked;  ///< Of tracking.tum.
};

/// Flies a scenario and judges the flight. Touches no file. Throws as FlyClosedLoop does.
FlightResult Fly(const Scenario& scenario, FlightObservers observers = {},
                 const util::StopRequested& stop_requested = nullptr);

/// Judges a flight that has been flown.
FlightResult JudgeFlight(const Scenario& scenario, const FlightLog& log);

/// The text of result.json and timing.json.
std::string ResultJson(const Scenario& scenario, const FlightResult& result);
std::string TimingJson(const Timing& timing);

}  // namespace touchdown::runner
