#pragma once

#include "estimator/pad/edges.h"
#include "models/describe.h"

namespace touchdown::estimator::paper {

/// How a pair of components that meets the geometric constraint is verified.
enum class Verify {
  kNone,      ///< Not at all, as published.
  kTemplate,  ///< By a template match of the pad's artwork on the ring's plane.
};

/// The options of the strategy `paper` that a scenario sets.
struct PaperOptions {
  pad::ContourPoints contour_points = pad::ContourPoints::kSubpixel;
  Verify verify = Verify::kTemplate;
};

void Describe(models::ConfigVisitor& v, PaperOptions& options);

}  // namespace touchdown::estimator::paper
