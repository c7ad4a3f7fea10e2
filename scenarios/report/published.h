#pragma once

#include <array>
#include <string_view>

namespace touchdown::report {

/// A row of Table I of the paper: RMSE of one coordinate of the vision pose.
struct TableOneRow {
  std::string_view label;
  std::string_view metric;  ///< Name of the corresponding flight metric.
  std::string_view key;     ///< Short name of the same quantity in the unit of the row.
  double scale;             ///< Factor from the unit of the metric to the unit of the row.
  std::string_view unit;
  std::array<double, 3> published;  ///< Published values: hand-held, hovering, autonomous.
};

inline constexpr std::array<TableOneRow, 6> kTableOne = {
    {{"XY", "estimate.xy_rmse_m", "xy_mm", 1e3, "mm", {43.1, 38.8, 33.7}},
     {"Z", "estimate.z_rmse_m", "z_mm", 1e3, "mm", {7.9, 5.7, 6.8}},
     {"3D", "estimate.xyz_rmse_m", "xyz_mm", 1e3, "mm", {43.8, 39.2, 34.4}},
     {"Roll", "estimate.roll_rmse_deg", "roll_deg", 1.0, "deg", {1.4, 1.3, 1.4}},
     {"Pitch", "estimate.pitch_rmse_deg", "pitch_deg", 1.0, "deg", {1.2, 1.4, 1.5}},
     {"Yaw", "estimate.yaw_rmse_deg", "yaw_deg", 1.0, "deg", {7.2, 4.8, 2.7}}}};

}  // namespace touchdown::report
