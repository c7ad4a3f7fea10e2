#pragma once

#include <array>
#include <cstdint>

#include "models/random_stream.h"
#include "models/signals.h"
#include "sim/packed_image.h"

namespace touchdown::sim {

/// Pixel noise: Gaussian, independent from pixel to pixel and frame to frame (stream "camera.noise"), followed by
/// rounding to 8 bits. The values come from a table of 4096 quantiles of the normal distribution, the largest at 3.7
/// sigma.
class ImageNoise {
 public:
  static constexpr double kMaxSigma = 64.0;

  /// `sigma` in grey levels of 255, 0 for none. Throws InputError when it is not within [0, kMaxSigma].
  ImageNoise(double sigma, std::uint64_t seed);

  models::Image Apply(const FineImage& frame);

 private:
  static constexpr int kIndexBits = 12;

  std::array<std::int32_t, 1 << kIndexBits> table_;  ///< In units of 1/256 grey level.
  models::RandomStream random_;
};

}  // namespace touchdown::sim
