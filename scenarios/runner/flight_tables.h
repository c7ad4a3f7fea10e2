#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scenarios/runner/flight_log.h"

namespace touchdown::runner {

/// flight.csv: one row for each IMU tick. A cell is empty where there is no value, as before the first vision pose.
/// Numbers are the shortest that read back to the same double.
std::string FlightCsv(const FlightLog& log);

/// frames.csv: one row for each delivered frame; true values are at mid-exposure. The covariance is of (position in m,
/// rotation vector in W in rad), its upper triangle by rows.
std::string FramesCsv(const FlightLog& log);

/// tracking.csv: one row for each pose of the tracking system, beside the true pose.
std::string TrackingCsv(const FlightLog& log);

/// frame_timing.csv: one row for each delivered frame with its wall-clock times.
std::string FrameTimingCsv(const FlightLog& log);

/// Name and content of a file.
using NamedText = std::pair<std::string, std::string>;

/// Every table and trajectory of a flight: flight.csv, frames.csv, tracking.csv, frame_timing.csv, truth.tum,
/// estimate.tum, tracking.tum.
std::vector<NamedText> WriteTables(const FlightLog& log);

/// SHA-256, in hexadecimal, of flight.csv followed by frames.csv. Builds no text in memory.
std::string LogDigest(const FlightLog& log);

}  // namespace touchdown::runner
