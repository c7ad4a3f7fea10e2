#pragma once

#include <string>

#include "scenarios/report/flight_files.h"

namespace touchdown::report {

/// Signature that identifies the report page of a flight.
inline constexpr char kFlightPageSignature[] = "<meta name=\"generator\" content=\"Touchdown flight report\">";

/// Builds the report page of a flight: verdict, criteria, comparison with the paper, plots over time, ground track and
/// scenario (docs/report.md). The page is one HTML file without external references, except for the video flight.mp4 in
/// the same directory. Throws InputError, naming file, line and key or column, when a file is invalid.
std::string FlightPage(const FlightFiles& files);

}  // namespace touchdown::report
