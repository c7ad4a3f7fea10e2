#include "sim/image_noise.h"

#include <algorithm>
#include <cmath>

#include "models/angles.h"
#include "models/error.h"

namespace touchdown::sim {
namespace {

constexpr int kDrawBits = 64;

/// The standard normal's quantile for p in [0.5, 1), by Newton's method on the distribution function, which is concave
/// there: no overshoot from 0.
double UpperNormalQuantile(double p) {
  double x = 0.0;
  for (int i = 0; i < 60; ++i) {
    const double density = std::exp(-0.5 * x * x) / std::sqrt(2.0 * models::kPi);
    const double step = (p - 0.5 * std::erfc(-x / std::sqrt(2.0))) / density;
    x += step;
    if (std::abs(step) < 1e-12) break;
  }
  return x;
}

}  // namespace

ImageNoise::ImageNoise(double sigma, std::uint64_t seed) : random_(seed, "camera.noise") {
  if (!(sigma >= 0.0 && sigma <= kMaxSigma)) throw InputError("the camera's noise must be within 0 and 64 grey levels");
  const std::size_t half = table_.size() / 2;
  double sum_of_squares = 0.0;
  std::array<double, (1 << kIndexBits) / 2> quantiles{};
  for (std::size_t i = 0; i < half; ++i) {
    quantiles[i] = UpperNormalQuantile((static_cast<double>(half + i) + 0.5) / static_cast<double>(table_.size()));
    sum_of_squares += quantiles[i] * quantiles[i];
  }
  const double scale = 256.0 * sigma / std::sqrt(sum_of_squares / static_cast<double>(half));
  for (std::size_t i = 0; i < half; ++i) {
    table_[half + i] = static_cast<std::int32_t>(std::lround(scale * quantiles[i]));
    table_[half - 1 - i] = -table_[half + i];
  }
}

models::Image ImageNoise::Apply(const FineImage& frame) {
  models::Image image(frame.width, frame.height);
  constexpr std::uint64_t kMask = (1u << kIndexBits) - 1;
  constexpr std::size_t kPerDraw = kDrawBits / kIndexBits;
  const std::size_t pixels = frame.pixels.size();
  for (std::size_t begin = 0; begin < pixels; begin += kPerDraw) {
    std::uint64_t bits = random_.Bits();
    const std::size_t end = std::min(begin + kPerDraw, pixels);
    for (std::size_t i = begin; i < end; ++i, bits >>= kIndexBits) {
      const std::int32_t level = (frame.pixels[i] + table_[bits & kMask] + 128) >> 8;
      image.pixels[i] = static_cast<std::uint8_t>(std::clamp(level, 0, 255));
    }
  }
  return image;
}

}  // namespace touchdown::sim
