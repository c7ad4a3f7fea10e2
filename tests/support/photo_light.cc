#include "tests/support/photo_light.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "models/angles.h"

namespace touchdown::tests {
namespace {

using Eigen::Vector2d;
using models::kPi;
using models::RandomStream;

/// Draws a shadow with an edge across the ring. Returns the fraction of the light: `darkest` inside the shadow, 1
/// outside.
cv::Mat1f DrawShadow(cv::Size size, const cv::Rect2d& ring_box, double darkest, RandomStream& random) {
  const cv::Point2d through(ring_box.x + random.Uniform(0.1, 0.9) * ring_box.width,
                            ring_box.y + random.Uniform(0.1, 0.9) * ring_box.height);
  const double angle = random.Uniform(-kPi, kPi), reach = 3.0 * size.width;
  const cv::Point2d along(std::cos(angle), std::sin(angle)), away(-along.y, along.x);
  const double breadth = random.Bernoulli(0.5) ? reach : random.Uniform(0.15, 0.8) * ring_box.width;
  cv::Mat1f shade(size, 1.0F);
  std::vector<cv::Point> outline;
  for (const cv::Point2d& p : {through - reach * along, through + reach * along,
                               through + reach * along + breadth * away, through - reach * along + breadth * away}) {
    outline.emplace_back(static_cast<int>(p.x), static_cast<int>(p.y));
  }
  cv::fillConvexPoly(shade, outline, cv::Scalar(darkest), cv::LINE_8);
  const double soft =
      ring_box.width * (random.Bernoulli(0.5) ? random.Uniform(0.005, 0.02) : random.Uniform(0.02, 0.2));
  const int side = 2 * static_cast<int>(soft) + 1;
  cv::blur(shade, shade, {side, side});
  cv::blur(shade, shade, {side, side});
  return shade;
}

}  // namespace

cv::Mat1f GaussianSpot(cv::Size size, const Vector2d& center, double radius_u, double radius_v, double angle) {
  constexpr int kReduce = 4;
  cv::Mat1f bell(size.height / kReduce + 1, size.width / kReduce + 1);
  const double c = std::cos(angle), s = std::sin(angle);
  for (int row = 0; row < bell.rows; ++row) {
    for (int column = 0; column < bell.cols; ++column) {
      const double du = kReduce * column - center.x(), dv = kReduce * row - center.y();
      const double a = (c * du + s * dv) / radius_u, b = (-s * du + c * dv) / radius_v;
      bell(row, column) = static_cast<float>(std::exp(-0.5 * (a * a + b * b)));
    }
  }
  cv::Mat1f fine;
  cv::resize(bell, fine, size, 0, 0, cv::INTER_LINEAR);
  return fine;
}

cv::Mat1f DrawLight(cv::Size size, const cv::Rect2d& ring_box, double shadow, RandomStream& random) {
  const double slope = random.Uniform(0.0, 0.45), heading = random.Uniform(-kPi, kPi);
  cv::Mat1f coarse(size.height / 16 + 2, size.width / 16 + 2), light;
  for (int row = 0; row < coarse.rows; ++row) {
    for (int column = 0; column < coarse.cols; ++column) {
      const double u = 2.0 * column / coarse.cols - 1.0, v = 2.0 * row / coarse.rows - 1.0;
      coarse(row, column) = static_cast<float>(1.0 + slope * (u * std::cos(heading) + v * std::sin(heading)));
    }
  }
  cv::resize(coarse, light, size, 0, 0, cv::INTER_LINEAR);
  if (random.Bernoulli(0.4)) {
    const Vector2d at(random.Uniform(0.0, size.width), random.Uniform(0.0, size.height));
    const double radius = random.Uniform(0.25, 0.8) * size.width;
    light += random.Uniform(0.2, 0.9) * GaussianSpot(size, at, radius, radius, 0.0);
  }
  if (shadow < 1.0) light = light.mul(DrawShadow(size, ring_box, shadow, random));
  return light;
}

void AddGlare(double strength, const cv::Rect2d& ring_box, const cv::Mat1f& toner, RandomStream& random,
              cv::Mat1f& radiance) {
  if (strength <= 0.0) return;
  const int patches = random.UniformInt(1, 2);
  for (int i = 0; i < patches; ++i) {
    const Vector2d at(ring_box.x + random.Uniform(0.0, 1.0) * ring_box.width,
                      ring_box.y + random.Uniform(0.0, 1.0) * ring_box.height);
    const double radius = std::max(ring_box.width, ring_box.height) * random.Uniform(0.05, 0.22);
    const cv::Mat1f bell =
        GaussianSpot(radiance.size(), at, radius, radius * random.Uniform(0.4, 1.0), random.Uniform(-kPi, kPi));
    radiance += strength * bell.mul(0.35 + 0.65 * toner);
  }
}

}  // namespace touchdown::tests
