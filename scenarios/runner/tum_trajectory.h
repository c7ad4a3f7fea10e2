#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>

#include "models/time.h"
#include "scenarios/runner/flight_log.h"

namespace touchdown::runner {

using Trajectory = std::map<models::Tick, Eigen::Isometry3d>;

/// A trajectory of a body in W in the format of the TUM RGB-D benchmark, as evo and others read it: a line
/// "t_s x_m y_m z_m qx qy qz qw" for each pose, rising in time. Numbers are the shortest that read back to the same
/// double.
std::string TumText(const Trajectory& trajectory, const models::TimeBase& time);

/// The truth: at every IMU tick, every frame's mid-exposure and every pose of the tracking system, so that each of the
/// other trajectories finds its own time in it.
Trajectory TrueTrajectory(const FlightLog& log);

/// The unfiltered vision pose of every frame with status ok, at mid-exposure.
Trajectory EstimatedTrajectory(const FlightLog& log);

/// What the tracking system says.
Trajectory TrackedTrajectory(const FlightLog& log);

}  // namespace touchdown::runner
