#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "models/random_stream.h"

namespace touchdown::tests {

/// What may lie under and around a sheet: wood, tiles, carpet, concrete, plain, page, desk, cups.
const std::vector<std::string>& FloorKinds();

inline constexpr int kFloorSide_px = 1024;

/// Reflectance of 255 of a square of floor, kFloorSide_px wide, that continues mirrored. The middle disc of
/// `free_radius_px` holds no objects.
cv::Mat1b DrawFloor(const std::string& kind, double free_radius_px, models::RandomStream& random);

}  // namespace touchdown::tests
