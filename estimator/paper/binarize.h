#pragma once

#include "models/signals.h"

namespace touchdown::estimator::paper {

/// Settings of the adaptive threshold (Sec. IV-A.1).
struct BinarizeConfig {
  /// Side of the averaging window, px; odd. A window narrower than about three stroke widths at the lowest height makes
  /// the strokes hollow. A smaller window adapts better to uneven light.
  int window_px = 101;
  /// A pixel is dark when it is below (1 - relative_margin) * mean - absolute_margin. Larger margins reject noise and
  /// faint texture; smaller margins detect the pad at lower contrast.
  double relative_margin = 0.15;
  double absolute_margin = 6.0;  ///< Gray values, 0 to 255.

  /// Throws InputError unless window_px is odd and 1 to 255, relative_margin is in [0, 1), and absolute_margin is
  /// finite and not negative.
  void Validate() const;
};

/// Adaptive threshold relative to the mean of the window around each pixel, computed with an integral image
/// (Sec. IV-A.1). The result is 255 for dark pixels and 0 for others. At the borders only the part of the window inside
/// the image is averaged.
models::Image Binarize(const models::ImageView& image, const BinarizeConfig& config = {});

}  // namespace touchdown::estimator::paper
