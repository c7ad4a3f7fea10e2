#include "sim/render/packed_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "models/random_stream.h"

namespace touchdown::sim {
namespace {

constexpr double kOne = 1 << PackedImage::kFractionBits;

models::Image RandomImage(int width, int height) {
  models::RandomStream random(1, "test");
  models::Image image(width, height);
  for (std::uint8_t& level : image.pixels) level = static_cast<std::uint8_t>(random.UniformInt(0, 255));
  return image;
}

double Bilinear(const models::Image& image, double x, double y) {
  x = std::clamp(x, 0.0, image.width - 1.001);
  y = std::clamp(y, 0.0, image.height - 1.001);
  const int u = static_cast<int>(x), v = static_cast<int>(y);
  const models::ImageView view = image.View();
  return std::lerp(std::lerp(1.0 * view.At(u, v), 1.0 * view.At(u + 1, v), x - u),
                   std::lerp(1.0 * view.At(u, v + 1), 1.0 * view.At(u + 1, v + 1), x - u), y - v);
}

TEST(PackedImage, InterpolatesBilinearly) {
  const models::Image image = RandomImage(37, 23);
  models::RandomStream random(2, "test");
  std::vector<std::int32_t> x(500), y(500);
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = static_cast<std::int32_t>(kOne * random.Uniform(0.0, 35.9));
    y[i] = static_cast<std::int32_t>(kOne * random.Uniform(0.0, 21.9));
  }
  std::vector<std::uint32_t> sums(x.size(), 0);
  PackedImage(image).AddLookups({.x = x.data(), .y = y.data(), .count = 500}, sums.data());
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_NEAR(sums[i] / 65536.0, Bilinear(image, x[i] / kOne, y[i] / kOne), 2.0) << i;
  }
}

/// A single lookup in plain integer arithmetic, which every CPU's copy of the code must match to the last bit.
std::uint32_t ExactLookup(const models::ImageView& image, std::int32_t x, std::int32_t y) {
  const std::int32_t u = x >> 16, v = y >> 16;
  const auto right = static_cast<std::uint32_t>(x >> 8 & 255), low = static_cast<std::uint32_t>(y >> 8 & 255);
  const std::uint32_t upper = image.At(u, v) * (256u - right) + image.At(u + 1, v) * right;
  const std::uint32_t lower = image.At(u, v + 1) * (256u - right) + image.At(u + 1, v + 1) * right;
  return upper * (256u - low) + lower * low;
}

TEST(PackedImage, ReturnsTheSameIntegersOnEveryCpu) {
  const models::Image image = RandomImage(61, 47);
  models::RandomStream random(3, "test");
  for (const int count : {1, 7, 8, 64, 333}) {
    std::vector<std::int32_t> x, y;
    std::vector<std::uint32_t> sums(static_cast<std::size_t>(count), 11);
    for (int i = 0; i < count; ++i) {
      x.push_back(static_cast<std::int32_t>(kOne * random.Uniform(0.0, 59.9)));
      y.push_back(static_cast<std::int32_t>(kOne * random.Uniform(0.0, 45.9)));
    }
    PackedImage(image).AddLookups({.x = x.data(), .y = y.data(), .count = count}, sums.data());
    for (std::size_t i = 0; i < sums.size(); ++i) EXPECT_EQ(sums[i], 11 + ExactLookup(image.View(), x[i], y[i]));
  }
}

TEST(PackedImage, ReturnsItsPixelsAtIntegerPositions) {
  const models::Image image = RandomImage(16, 8);
  std::vector<std::int32_t> x(15), y(15, 3 << 16);
  for (int i = 0; i < 15; ++i) x[static_cast<std::size_t>(i)] = i << 16;
  std::vector<std::uint32_t> sums(15, 0);
  PackedImage(image).AddLookups({.x = x.data(), .y = y.data(), .count = 15}, sums.data());
  for (int i = 0; i < 15; ++i) EXPECT_EQ(sums[static_cast<std::size_t>(i)], image.View().At(i, 3) * 65536u);
}

TEST(PackedImage, ShiftsARunByIncreasingSteps) {
  const models::Image image = RandomImage(64, 8);
  const std::vector<std::int32_t> x(10, 2 << 16), y(10, 1 << 16);
  std::vector<std::uint32_t> sums(10, 0);
  PackedImage(image).AddLookups(
      {.x = x.data(), .y = y.data(), .count = 10, .shift = {1 << 16, 0}, .step = {3 << 16, 0}}, sums.data());
  for (int i = 0; i < 10; ++i) EXPECT_EQ(sums[static_cast<std::size_t>(i)], image.View().At(3 + 3 * i, 1) * 65536u);
}

TEST(PackedImage, ClampsPositionsBeyondItsBorder) {
  const models::Image image = RandomImage(12, 9);
  const std::vector<std::int32_t> x{-(50 << 16), 50 << 16, 50 << 16}, y{-(50 << 16), -(50 << 16), 50 << 16};
  std::vector<std::uint32_t> sums(3, 0);
  PackedImage(image).AddLookups({.x = x.data(), .y = y.data(), .count = 3}, sums.data());
  EXPECT_EQ(sums[0], image.View().At(0, 0) * 65536u);
  EXPECT_NEAR(sums[1] / 65536.0, image.View().At(11, 0), 1.0);
  EXPECT_NEAR(sums[2] / 65536.0, image.View().At(11, 8), 2.0);
}

TEST(WriteMeans, DividesByTheNumberOfTaps) {
  const std::vector<std::uint32_t> sums{0, 5u * 65536u * 200u, 5u * 65536u * 255u};
  std::vector<std::uint16_t> levels(3);
  WriteMeans(sums, 5, levels.data());
  EXPECT_EQ(levels[0], 0);
  EXPECT_EQ(levels[1], 200 * 256);
  EXPECT_EQ(levels[2], 255 * 256);
}

}  // namespace
}  // namespace touchdown::sim
