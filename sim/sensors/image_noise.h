#pragma once

#include <cstdint>
#include <vector>

#include "models/random_stream.h"
#include "models/signals.h"
#include "sim/render/packed_image.h"

namespace touchdown::sim {

/// Pixel noise: Gaussian, independent from pixel to pixel and frame to frame (stream "camera.noise"), followed by
/// rounding to 8 bits. Every row of a frame uses a random section of a long strip of noise that is drawn once: one pair
/// of rows in a thousand overlaps in the strip, almost never at the same columns.
class ImageNoise {
 public:
  static constexpr double kMaxSigma = 24.0;

  /// `sigma` is in gray levels of 0 to 255; 0 is no noise. Throws InputError when it is not within [0, kMaxSigma], up
  /// to which the strip's numbers represent five sigma.
  ImageNoise(double sigma, std::uint64_t seed);

  /// Adds noise to a frame and rounds it. Throws std::logic_error for a frame wider than 65536 px.
  models::Image Apply(const FineImage& frame);

 private:
  models::RandomStream random_;
  std::vector<std::int16_t> strip_;  ///< In units of 1/256 gray level.
};

}  // namespace touchdown::sim
