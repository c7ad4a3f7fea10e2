#pragma once

#include <string>

#include "scenarios/flight/flight_log.h"

namespace touchdown::scenarios {

// Trajectories of the body in W in the format of the TUM RGB-D benchmark, as evo and others read them: a line
// "t_s x_m y_m z_m qx qy qz qw" for each pose, rising in time. Numbers are the shortest that read back to the same
// double.

/// The truth: at every IMU tick, every frame's mid-exposure and every pose of the tracking system, so that each of the
/// other trajectories finds its own time in it.
std::string TruthTum(const FlightLog& log);

/// The unfiltered vision pose of every frame that has one, at mid-exposure.
std::string EstimateTum(const FlightLog& log);

/// What the tracking system says.
std::string TrackingTum(const FlightLog& log);

}  // namespace touchdown::scenarios
