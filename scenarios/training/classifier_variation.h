#pragma once

#include <vector>

#include "models/random_stream.h"

namespace touchdown::training {

/// Data augmentation for patterns: applies a random mirroring or rotation by a multiple of 90 degrees and, with
/// probability 0.5, a slight homography followed by stretching to the bounding box. The class does not change.
/// `pattern` has estimator::paper::kPatternSide^2 cells.
std::vector<float> VaryPattern(const std::vector<float>& pattern, models::RandomStream& random);

}  // namespace touchdown::training
