#pragma once

#include <string>

#include "scenarios/report/flight_files.h"

namespace touchdown::report {

/// What every page of a flight holds.
inline constexpr char kFlightPageSignature[] = "<meta name=\"generator\" content=\"Touchdown flight report\">";

/// A flight as one page of HTML that needs nothing but itself and, for the picture, the flight.mp4 beside it: verdict,
/// criteria, the figures beside the paper's, plots over time, the way over the pad, the scenario (docs/report.md).
/// Throws InputError, naming file, line and key or column, when a file is damaged.
std::string FlightPage(const FlightFiles& files);

}  // namespace touchdown::report
