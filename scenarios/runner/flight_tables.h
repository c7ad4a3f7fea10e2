#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scenarios/runner/flight_log.h"

namespace touchdown::runner {

/// flight.csv: one row for each IMU tick. A cell is empty if it has no value, for example before the first vision
/// pose. Numbers have the fewest digits that read back to the same double.
std::string FlightCsv(const FlightLog& log);

/// frames.csv: one row for each delivered frame; true values are at mid-exposure. The covariance refers to (position in
/// m, rotation vector in W in rad); its upper triangle is listed row by row.
std::string FramesCsv(const FlightLog& log);

/// frame_timing.csv: one row for each delivered frame with its wall-clock times.
std::string FrameTimingCsv(const FlightLog& log);

/// Name and content of a file.
using NamedText = std::pair<std::string, std::string>;

/// Table of each logged sensor, for example tracking.csv: one row for each reading, with the true pose.
std::vector<NamedText> SensorTables(const FlightLog& log);

/// All tables and trajectories of a flight: flight.csv, frames.csv, frame_timing.csv, truth.tum, estimate.tum,
/// tracking.tum, and the tables of the logged sensors.
std::vector<NamedText> WriteTables(const FlightLog& log);

/// SHA-256, in hexadecimal, of flight.csv followed by frames.csv. The text is not built in memory.
std::string LogDigest(const FlightLog& log);

}  // namespace touchdown::runner
