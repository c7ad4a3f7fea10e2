#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/report/flight_files.h"
#include "scenarios/report/thinning.h"

namespace touchdown::report {

/// Two frames more than this many camera periods apart have a missing one between them.
inline constexpr double kMissingFrame = 1.5;

/// A pose over time: position in W in m, Tait-Bryan angles in deg. Yaw runs on beyond +-180 degrees where it turns.
struct PoseSeries {
  Series x_m, y_m, z_m;
  Series roll_deg, pitch_deg, yaw_deg;

  std::array<Series*, 6> all() { return {&x_m, &y_m, &z_m, &roll_deg, &pitch_deg, &yaw_deg}; }
};

/// A flight's tables, as they are drawn.
///
/// The pad looks the same turned by 180 degrees about Z: of the two poses that vision and the estimate may mean, the
/// one whose yaw is nearer to the truth's is here, as in the metrics. So is the set-point's yaw.
struct FlightSeries {
  /// A time in which a name held.
  struct Span {
    std::string name;
    double from_s = 0.0;
    double to_s = 0.0;
  };

  double duration_s = 0.0;  ///< Of the last row.

  // On the IMU's ticks.
  std::vector<double> t_s;
  PoseSeries truth, estimate;
  PoseSeries set_point;  ///< While the motors run.
  std::array<Series, 4> command_rad_s;
  std::vector<Span> phases;

  // At the mid-exposure of the frames that arrived.
  std::vector<double> frame_t_s;
  PoseSeries vision, frame_truth;  ///< Vision's where the status is ok.
  Series vision_ms;
  std::vector<Span> statuses;  ///< Of frames that follow upon each other; a span ends where frames are missing.
};

/// Reads the tables. `frame_period_s` is the camera's. Throws InputError, naming file, line and column, for a table
/// that is damaged.
FlightSeries ReadFlightSeries(const FlightFiles& files, double frame_period_s);

}  // namespace touchdown::report
