#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/report/flight_files.h"
#include "scenarios/report/thinning.h"

namespace touchdown::report {

/// Two successive frames that are farther apart than this, in camera periods, have a missing frame between them.
inline constexpr double kMissingFrame = 1.5;

/// Pose over time: position in W in m, Tait-Bryan angles in deg. Yaw is unwrapped and may exceed +-180 degrees.
struct PoseSeries {
  Series x_m, y_m, z_m;
  Series roll_deg, pitch_deg, yaw_deg;

  std::array<Series*, 6> all() { return {&x_m, &y_m, &z_m, &roll_deg, &pitch_deg, &yaw_deg}; }
};

/// Time series of a flight, from its CSV tables, prepared for plotting.
///
/// The pad looks the same after a rotation by 180 degrees about Z. The yaw ambiguity of the vision pose, the estimate
/// and the set-point is resolved towards the true yaw, as in the metrics.
struct FlightSeries {
  /// Time interval during which a name, of a phase or of a status, applies.
  struct Span {
    std::string name;
    double from_s = 0.0;
    double to_s = 0.0;
  };

  double duration_s = 0.0;  ///< Time of the last row of flight.csv.

  // At the IMU ticks.
  std::vector<double> t_s;
  PoseSeries truth, estimate;
  PoseSeries set_point;  ///< nullopt while the motors are off.
  std::array<Series, 4> command_rad_s;
  std::vector<Span> phases;

  // At the mid-exposure of each received frame.
  std::vector<double> frame_t_s;
  PoseSeries vision, frame_truth;  ///< Vision is nullopt unless the status is ok.
  Series vision_ms;
  std::vector<Span> statuses;  ///< One per run of frames of equal status. A span ends where frames are missing.
};

/// Reads the time series from the CSV tables. `frame_period_s` is the camera period. Throws InputError, naming file,
/// line and column, when a table is invalid.
FlightSeries ReadFlightSeries(const FlightFiles& files, double frame_period_s);

}  // namespace touchdown::report
