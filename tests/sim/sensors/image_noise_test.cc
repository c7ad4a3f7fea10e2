#include "sim/sensors/image_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "models/error.h"

namespace touchdown::sim {
namespace {

FineImage Plain(double level, int width = 640, int height = 480) {
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return {width, height, std::vector<std::uint16_t>(pixels, static_cast<std::uint16_t>(std::lround(256.0 * level)))};
}

double Mean(const models::Image& image) {
  double sum = 0.0;
  for (const std::uint8_t level : image.pixels) sum += level;
  return sum / static_cast<double>(image.pixels.size());
}

/// Covariance of the levels about 100, between the pixels of one image and the pixels of another image `lag` later.
double Covariance(const models::Image& a, const models::Image& b, std::size_t lag) {
  double sum = 0.0;
  const std::size_t count = a.pixels.size() - lag;
  for (std::size_t i = 0; i < count; ++i) sum += (a.pixels[i] - 100.0) * (b.pixels[i + lag] - 100.0);
  return sum / static_cast<double>(count);
}

TEST(ImageNoise, HasTheRequestedMeanAndSigma) {
  for (const double sigma : {1.0, 3.0, 8.0}) {
    const models::Image image = ImageNoise(sigma, 1).Apply(Plain(100.0));
    EXPECT_NEAR(Mean(image), 100.0, 4.0 * sigma / std::sqrt(640.0 * 480.0));
    EXPECT_NEAR(Covariance(image, image, 0), sigma * sigma + 1.0 / 12.0, 0.02 * sigma * sigma);
  }
}

TEST(ImageNoise, IsNormallyDistributed) {
  const models::Image image = ImageNoise(10.0, 2).Apply(Plain(100.0));
  for (const double z : {-2.0, -1.0, 0.0, 1.0, 2.0}) {
    const double threshold = 100.5 + 10.0 * z;
    const auto below =
        std::count_if(image.pixels.begin(), image.pixels.end(), [&](std::uint8_t level) { return level < threshold; });
    const double expected = 0.5 * std::erfc(-(threshold - 100.0) / 10.0 / std::sqrt(2.0));
    EXPECT_NEAR(static_cast<double>(below) / static_cast<double>(image.pixels.size()), expected, 0.004) << z;
  }
}

TEST(ImageNoise, IsIndependentFromPixelToPixelAndFrameToFrame) {
  ImageNoise noise(3.0, 3);
  const models::Image first = noise.Apply(Plain(100.0)), second = noise.Apply(Plain(100.0));
  constexpr double kFourSigma = 4.0 * 9.0 / 554.0;
  for (const std::size_t lag : {1, 2, 3, 4, 5, 639, 640, 641})
    EXPECT_NEAR(Covariance(first, first, lag), 0.0, kFourSigma);
  for (const std::size_t lag : {0, 1, 5, 640}) EXPECT_NEAR(Covariance(first, second, lag), 0.0, kFourSigma);
}

TEST(ImageNoise, RoundsWithoutBias) {
  for (const double fraction : {0.125, 0.25, 0.5, 0.75}) {
    const models::Image image = ImageNoise(3.0, 4).Apply(Plain(100.0 + fraction));
    EXPECT_NEAR(Mean(image), 100.0 + fraction, 0.025);
  }
}

TEST(ImageNoise, RoundsToTheNearestLevelWithoutNoise) {
  ImageNoise noise(0.0, 1);
  EXPECT_EQ(noise.Apply(Plain(99.75)).pixels, models::Image(640, 480, 100).pixels);
  EXPECT_EQ(noise.Apply(Plain(100.25)).pixels, models::Image(640, 480, 100).pixels);
  EXPECT_EQ(noise.Apply(Plain(255.0)).pixels, models::Image(640, 480, 255).pixels);
}

TEST(ImageNoise, StaysWithinEightBits) {
  const models::Image dark = ImageNoise(24.0, 5).Apply(Plain(2.0)), bright = ImageNoise(24.0, 5).Apply(Plain(253.0));
  EXPECT_EQ(*std::min_element(dark.pixels.begin(), dark.pixels.end()), 0);
  EXPECT_LT(*std::max_element(dark.pixels.begin(), dark.pixels.end()), 150);
  EXPECT_EQ(*std::max_element(bright.pixels.begin(), bright.pixels.end()), 255);
  EXPECT_GT(*std::min_element(bright.pixels.begin(), bright.pixels.end()), 100);
}

TEST(ImageNoise, DependsOnItsSeedOnly) {
  EXPECT_EQ(ImageNoise(3.0, 6).Apply(Plain(50.0)).pixels, ImageNoise(3.0, 6).Apply(Plain(50.0)).pixels);
  EXPECT_NE(ImageNoise(3.0, 6).Apply(Plain(50.0)).pixels, ImageNoise(3.0, 7).Apply(Plain(50.0)).pixels);
}

TEST(ImageNoise, RejectsASigmaOutOfRange) {
  EXPECT_THROW(ImageNoise(-1.0, 1), InputError);
  EXPECT_THROW(ImageNoise(std::nan(""), 1), InputError);
  EXPECT_THROW(ImageNoise(25.0, 1), InputError);
}

}  // namespace
}  // namespace touchdown::sim
