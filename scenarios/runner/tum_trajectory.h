#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>

#include "models/time.h"
#include "scenarios/runner/flight_log.h"

namespace touchdown::runner {

/// Poses X_WB by tick.
using Trajectory = std::map<models::Tick, Eigen::Isometry3d>;

/// Trajectory of a body in W in the format of the TUM RGB-D benchmark, which evo and other tools read: one line
/// "t_s x_m y_m z_m qx qy qz qw" for each pose, with increasing time. Numbers have the fewest digits that read back to
/// the same double.
std::string TumText(const Trajectory& trajectory, const models::TimeBase& time);

/// True trajectory, at every IMU tick, mid-exposure and tick of the tracking system, so that it has a pose at each time
/// of the other trajectories.
Trajectory TrueTrajectory(const FlightLog& log);

/// Trajectory of the unfiltered vision poses of frames with status ok, at mid-exposure.
Trajectory EstimatedTrajectory(const FlightLog& log);

/// Trajectory of the tracking system.
Trajectory TrackedTrajectory(const FlightLog& log);

}  // namespace touchdown::runner
