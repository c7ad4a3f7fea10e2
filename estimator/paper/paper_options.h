#pragma once

namespace touchdown::estimator {

/// Where a frame's edge points are taken: on Canny's pixels, or at their sub-pixel place along the gradient. The paper
/// leaves it open.
enum class ContourPoints { kInteger, kSubpixel };

/// What a scenario may say of the strategy `paper`.
struct PaperOptions {
  ContourPoints contour_points = ContourPoints::kSubpixel;
};

}  // namespace touchdown::estimator
