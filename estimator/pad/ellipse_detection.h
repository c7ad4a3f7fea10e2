#pragma once

#include <vector>

#include "estimator/pad/ellipse_fit.h"
#include "models/signals.h"

namespace touchdown::estimator::pad {

/// Settings of DetectEllipses.
struct EllipseDetectionConfig {
  /// Canny's thresholds on the 3x3 Sobel gradient of the smoothed image. Lower thresholds find fainter rings and take
  /// more time.
  double canny_low = 20.0;
  double canny_high = 40.0;
  /// Smallest fraction of the circumference that has an edge. A smaller value finds rings of which more is overexposed
  /// or covered, and yields more false rings.
  double min_coverage = 0.66;
  double min_semi_axis_px = 5.0;
  double min_axis_ratio = 0.3;  ///< Minor over major axis; 0.3 is a circle viewed at 72 degrees.
  int max_rings = 16;

  /// Throws InputError when a setting is invalid.
  void Validate() const;
};

/// Detects ellipses in raw px along which the image is dark inside and bright outside, such as the outer boundary of a
/// ring, even if it is interrupted. The ellipse with the highest edge coverage comes first.
///
/// It does not depend on connected components: each segment of edge pixels proposes the ellipse through it, and the
/// edges of the whole image are counted as inliers.
std::vector<Ellipse> DetectEllipses(const models::ImageView& image, const EllipseDetectionConfig& config = {});

}  // namespace touchdown::estimator::pad
