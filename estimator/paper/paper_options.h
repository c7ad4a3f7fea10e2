#pragma once

#include "estimator/pad/edges.h"

namespace touchdown::estimator::paper {

/// What a scenario may say of the strategy `paper`.
struct PaperOptions {
  pad::ContourPoints contour_points = pad::ContourPoints::kSubpixel;
};

}  // namespace touchdown::estimator::paper
