#pragma once

#include "estimator/pad/edges.h"
#include "models/describe.h"

namespace touchdown::estimator::paper {

/// Verification of a pair of components that satisfies the geometric constraint.
enum class Verify {
  kNone,      ///< No verification, as published.
  kTemplate,  ///< Template match of the pad's artwork on the ring's plane.
};

/// Options of the strategy `paper` that a scenario may set.
struct PaperOptions {
  pad::ContourPoints contour_points = pad::ContourPoints::kSubpixel;
  Verify verify = Verify::kTemplate;
};

void Describe(models::ConfigVisitor& v, PaperOptions& options);

}  // namespace touchdown::estimator::paper
