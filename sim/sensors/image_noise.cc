#include "sim/sensors/image_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "models/error.h"
#include "sim/render/cpu_clones.h"

namespace touchdown::sim {
namespace {

constexpr int kStrip = 1 << 20;
constexpr int kWidestRow = 1 << 16;

/// Noise normalized to zero mean and unit variance, so that the strip has exactly the requested sigma.
std::vector<double> UnitNoise(models::RandomStream& random) {
  std::vector<double> noise(kStrip);
  double sum = 0.0, sum_of_squares = 0.0;
  for (double& value : noise) {
    value = random.Normal();
    sum += value;
    sum_of_squares += value * value;
  }
  const double mean = sum / kStrip;
  const double sigma = std::sqrt(sum_of_squares / kStrip - mean * mean);
  for (double& value : noise) value = (value - mean) / sigma;
  return noise;
}

TOUCHDOWN_CLONE_FOR_CPUS
void AddNoise(const std::uint16_t* __restrict levels, const std::int16_t* __restrict noise, int count,
              std::uint8_t* __restrict pixels) {
  for (int i = 0; i < count; ++i) {
    const std::int32_t level = (levels[i] + noise[i] + 128) >> 8;
    pixels[i] = static_cast<std::uint8_t>(std::min(std::max(level, 0), 255));
  }
}

}  // namespace

ImageNoise::ImageNoise(double sigma, std::uint64_t seed) : random_(seed, "camera.noise") {
  if (!(sigma >= 0.0 && sigma <= kMaxSigma)) {
    throw InputError("the camera's noise_sigma must be from 0 to 24 gray levels");
  }
  using Limits = std::numeric_limits<std::int16_t>;
  strip_.reserve(kStrip);
  for (const double value : UnitNoise(random_)) {
    const double level = std::clamp<double>(std::round(256.0 * sigma * value), Limits::min(), Limits::max());
    strip_.push_back(static_cast<std::int16_t>(level));
  }
}

models::Image ImageNoise::Apply(const FineImage& frame) {
  if (frame.width > kWidestRow) {
    throw std::logic_error("the frame is wider than 65536 px, the limit of the noise strip");
  }
  models::Image image(frame.width, frame.height);
  const std::uint16_t* levels = frame.pixels.data();
  for (int v = 0; v < frame.height; ++v, levels += frame.width) {
    const std::int16_t* noise = strip_.data() + random_.UniformInt(0, kStrip - frame.width);
    AddNoise(levels, noise, frame.width, image.Row(v));
  }
  return image;
}

}  // namespace touchdown::sim
