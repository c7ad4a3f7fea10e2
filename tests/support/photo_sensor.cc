#include "tests/support/photo_sensor.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "tests/support/photo_light.h"

namespace touchdown::tests {

void Defocus(cv::Mat1f& radiance, double radius_px) {
  if (radius_px < 0.3) return;
  const int reach = static_cast<int>(std::ceil(radius_px));
  cv::Mat1f kernel(2 * reach + 1, 2 * reach + 1);
  for (int v = -reach; v <= reach; ++v) {
    for (int u = -reach; u <= reach; ++u) {
      kernel(v + reach, u + reach) = static_cast<float>(std::clamp(radius_px + 0.5 - std::hypot(u, v), 0.0, 1.0));
    }
  }
  cv::filter2D(radiance, radiance, -1, kernel / cv::sum(kernel)[0]);
}

void SmearAlong(cv::Mat1f& radiance, double length_px, double angle) {
  if (length_px < 0.5) return;
  const int reach = static_cast<int>(std::ceil(0.5 * length_px)) + 1;
  cv::Mat1f kernel = cv::Mat1f::zeros(2 * reach + 1, 2 * reach + 1);
  constexpr int kSamples = 64;
  for (int i = 0; i < kSamples; ++i) {
    const double at = ((i + 0.5) / kSamples - 0.5) * length_px;
    const double u = at * std::cos(angle) + reach, v = at * std::sin(angle) + reach;
    const int u0 = static_cast<int>(u), v0 = static_cast<int>(v);
    const auto a = static_cast<float>(u - u0), b = static_cast<float>(v - v0);
    kernel(v0, u0) += (1 - a) * (1 - b);
    kernel(v0, u0 + 1) += a * (1 - b);
    kernel(v0 + 1, u0) += (1 - a) * b;
    kernel(v0 + 1, u0 + 1) += a * b;
  }
  cv::filter2D(radiance, radiance, -1, kernel / cv::sum(kernel)[0]);
}

cv::Mat1b Develop(cv::Mat1f radiance, double exposure, double noise_sigma, int jpeg_quality,
                  models::RandomStream& random) {
  const cv::Size size = radiance.size();
  const double vignette = random.Uniform(0.0, 0.45), haze = random.Bernoulli(0.3) ? random.Uniform(0.0, 0.05) : 0.0;
  const double radius = 0.7 * std::hypot(size.width, size.height);
  radiance = radiance.mul(1.0 - vignette * (1.0 - GaussianSpot(size, {0.5 * size.width, 0.5 * size.height},
                                                               0.6 * radius, 0.6 * radius, 0.0)));
  radiance = radiance * exposure + haze;
  cv::min(radiance, 1.0, radiance);
  cv::max(radiance, 0.0, radiance);
  cv::pow(radiance, 1.0 / random.Uniform(1.7, 2.4), radiance);
  radiance *= 255.0;
  cv::Mat1f noise(size);
  cv::RNG rng(random.Bits());
  rng.fill(noise, cv::RNG::NORMAL, 0.0, noise_sigma);
  if (random.Bernoulli(0.5)) cv::blur(noise, noise, {2, 2});  // The camera has smoothed the noise.
  radiance += noise;
  if (random.Bernoulli(0.4)) {
    cv::Mat1f smooth;
    cv::GaussianBlur(radiance, smooth, {}, random.Uniform(0.8, 2.0));
    radiance += random.Uniform(0.3, 1.2) * (radiance - smooth);
  }
  cv::Mat1b image;
  radiance.convertTo(image, CV_8U);
  if (jpeg_quality < 100) {
    std::vector<std::uint8_t> bytes;
    cv::imencode(".jpg", image, bytes, {cv::IMWRITE_JPEG_QUALITY, jpeg_quality});
    image = cv::imdecode(bytes, cv::IMREAD_GRAYSCALE);
  }
  return image;
}

}  // namespace touchdown::tests
