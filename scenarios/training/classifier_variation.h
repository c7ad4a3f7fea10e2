#pragma once

#include <vector>

#include "models/random_stream.h"

namespace touchdown::training {

/// A pattern that the same thing might give from elsewhere: mirrored or turned by a multiple of 90 degrees, and half
/// the time seen through a slight homography, then stretched to its bounding box again. A ring, an H and clutter stay
/// what they are. `pattern` has estimator::kPatternSize cells.
std::vector<float> VaryPattern(const std::vector<float>& pattern, models::RandomStream& random);

}  // namespace touchdown::training
