#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "models/random_stream.h"

namespace touchdown::tests {

/// Kinds of floors: wood, tiles, carpet, concrete, plain, page, desk, cups.
const std::vector<std::string>& FloorKinds();

inline constexpr int kFloorSide_px = 1024;

/// Draws a square of floor, kFloorSide_px wide, which is continued by reflection: gray values 0 to 255. The disc of
/// radius `free_radius_px` around its center contains no objects.
cv::Mat1b DrawFloor(const std::string& kind, double free_radius_px, models::RandomStream& random);

}  // namespace touchdown::tests
