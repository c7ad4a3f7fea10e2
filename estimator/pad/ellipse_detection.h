#pragma once

#include <vector>

#include "estimator/pad/ellipse_fit.h"
#include "models/signals.h"

namespace touchdown::estimator::pad {

struct RingSearchConfig {
  /// Canny's thresholds on Sobel's gradient (3x3) of the smoothed image. Lower ones find fainter rings and cost time.
  double canny_low = 20.0;
  double canny_high = 40.0;
  /// Least share of the circumference at which an edge is seen. Smaller values find rings of which more is burnt out or
  /// covered, and more that are none.
  double least_coverage = 0.66;
  double smallest_semi_axis_px = 5.0;
  double least_axis_ratio = 0.3;  ///< Of a circle that is seen under 72 degrees.
  int most_rings = 16;

  /// Throws InputError when a setting is impossible.
  void Validate() const;
};

/// Ellipses along which the image is dark inside and bright outside, such as the outer boundary of a ring, whole or in
/// pieces; raw px, those first along which most edges are seen. It needs no component to hang together: each chain of
/// edge pixels proposes the ellipse through it, and the edges of the whole image vote on it.
std::vector<Ellipse> DetectEllipses(const models::ImageView& image, const RingSearchConfig& config = {});

}  // namespace touchdown::estimator::pad
