#include "models/bilinear.h"

#include <gtest/gtest.h>

namespace touchdown::models {
namespace {

TEST(BilinearGray, IsExactForAPlane) {
  Image image(5, 4);
  for (int v = 0; v < image.height; ++v) {
    for (int u = 0; u < image.width; ++u) image.Row(v)[u] = static_cast<std::uint8_t>(10 + 20 * u + 30 * v);
  }
  for (const Eigen::Vector2d& place : {Eigen::Vector2d(0, 0), {2.25, 1.5}, {3.75, 2.875}}) {
    const double gray = 10 + 20 * place.x() + 30 * place.y();
    EXPECT_DOUBLE_EQ(BilinearGray<double>(image.View(), place), gray);
    EXPECT_FLOAT_EQ(BilinearGray<float>(image.View(), place), static_cast<float>(gray));
  }
}

TEST(IsBetweenPixels, IsTrueFromTheFirstPixelToTheLast) {
  const Image image(5, 4);
  EXPECT_TRUE(IsBetweenPixels(image.View(), {0.0, 0.0}));
  EXPECT_TRUE(IsBetweenPixels(image.View(), {3.99, 2.99}));
  for (const Eigen::Vector2d& place : {Eigen::Vector2d(4.0, 0.0), {0.0, 3.0}, {-0.01, 0.0}, {0.0, -0.01}}) {
    EXPECT_FALSE(IsBetweenPixels(image.View(), place));
  }
}

}  // namespace
}  // namespace touchdown::models
