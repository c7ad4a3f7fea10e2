#pragma once

#include <array>

namespace touchdown::scenarios {

/// A row of the paper's Table I: RMSE hand-held, hovering and in autonomous flight.
struct TableOneRow {
  const char* label;
  const char* key;  ///< Of the same error as FlyAndSumUp tells it, in the row's unit.
  const char* unit;
  std::array<double, 3> published;
};

inline constexpr std::array<TableOneRow, 6> kTableOne = {{{"XY", "xy_mm", "mm", {43.1, 38.8, 33.7}},
                                                          {"Z", "z_mm", "mm", {7.9, 5.7, 6.8}},
                                                          {"3D", "xyz_mm", "mm", {43.8, 39.2, 34.4}},
                                                          {"roll", "roll_deg", "deg", {1.4, 1.3, 1.4}},
                                                          {"pitch", "pitch_deg", "deg", {1.2, 1.4, 1.5}},
                                                          {"yaw", "yaw_deg", "deg", {7.2, 4.8, 2.7}}}};

}  // namespace touchdown::scenarios
