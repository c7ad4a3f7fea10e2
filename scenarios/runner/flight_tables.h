#pragma once

#include <string>

#include "scenarios/runner/flight_log.h"

namespace touchdown::runner {

/// One row for each IMU tick. A cell is empty where there is nothing to tell, as before the first vision pose. Numbers
/// are the shortest that read back to the same double.
std::string FlightCsv(const FlightLog& log);

/// One row for each delivered frame; what is called true is at mid-exposure. The covariance is of (position in m,
/// rotation vector in W in rad), its upper triangle by rows.
std::string FramesCsv(const FlightLog& log);

/// One row for each pose of the tracking system, beside the truth.
std::string TrackingCsv(const FlightLog& log);

/// One row for each delivered frame: what it cost by the wall clock.
std::string FrameTimingCsv(const FlightLog& log);

}  // namespace touchdown::runner
