#pragma once

#include "models/signals.h"

namespace touchdown::estimator::paper {

/// Sec. IV-A.1.
struct BinarizeConfig {
  /// Side of the window whose mean a pixel is compared with; odd. It must be some three times as wide as the pad's
  /// strokes at the lowest height, or they come out hollow; a smaller one follows uneven light more closely.
  int window_px = 101;
  /// A pixel is dark when it is below (1 - relative_margin) * mean - absolute_margin. Larger margins keep noise and
  /// faint texture out, smaller ones find the pad in weaker contrast.
  double relative_margin = 0.15;
  double absolute_margin = 6.0;  ///< Of 255.

  /// Throws InputError when the window is not odd, positive and at most 255 px, or a margin is not finite, negative
  /// or (the relative one) at least 1.
  void Validate() const;
};

/// Adaptive threshold against the mean over the window around each pixel, through the integral image (Sec. IV-A.1): 255
/// where dark, 0 elsewhere. At the borders the mean is over the part of the window inside the image.
models::Image Binarize(const models::ImageView& image, const BinarizeConfig& config = {});

}  // namespace touchdown::estimator::paper
