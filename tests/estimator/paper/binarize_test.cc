#include "estimator/paper/binarize.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "models/error.h"
#include "models/pad_outline.h"
#include "models/random_stream.h"
#include "tests/support/synthetic_pad.h"

namespace touchdown::estimator::paper {
namespace {

models::Image RandomImage(int width, int height, std::uint64_t seed) {
  models::RandomStream random(seed, "tests.binarize");
  models::Image image(width, height);
  for (auto& pixel : image.pixels) pixel = static_cast<std::uint8_t>(random.UniformInt(0, 255));
  return image;
}

/// Threshold minus gray value of a pixel, computed from the definition without an integral image.
double Darkness(const models::ImageView& image, int u, int v, const BinarizeConfig& config) {
  double sum = 0.0;
  int count = 0;
  const int radius = config.window_px / 2;
  for (int y = std::max(0, v - radius); y <= std::min(image.height - 1, v + radius); ++y) {
    for (int x = std::max(0, u - radius); x <= std::min(image.width - 1, u + radius); ++x, ++count)
      sum += image.At(x, y);
  }
  return (1.0 - config.relative_margin) * sum / count - config.absolute_margin - image.At(u, v);
}

TEST(Binarize, ComparesPixelsWithTheMeanOfTheClippedWindow) {
  const BinarizeConfig config{.window_px = 9};
  for (const auto& [width, height] : {std::pair{40, 30}, {5, 40}, {40, 3}, {9, 9}, {1, 1}}) {
    const models::Image image = RandomImage(width, height, static_cast<std::uint64_t>(width));
    const models::Image dark = Binarize(image.View(), config);
    ASSERT_EQ(dark.width, width);
    ASSERT_EQ(dark.height, height);
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        const double darkness = Darkness(image.View(), u, v, config);
        if (std::abs(darkness) < 1e-3) continue;
        EXPECT_EQ(dark.View().At(u, v), darkness > 0.0 ? 255 : 0) << u << ", " << v;
      }
    }
  }
}

TEST(Binarize, UsesTheStride) {
  const models::Image whole = RandomImage(60, 40, 3);
  models::Image part(35, 40);
  for (int v = 0; v < 40; ++v) std::copy_n(whole.View().Row(v) + 7, 35, part.Row(v));
  const models::ImageView view{whole.pixels.data() + 7, 35, 40, 60};
  EXPECT_EQ(Binarize(view).pixels, Binarize(part.View()).pixels);
}

TEST(Binarize, FindsNoDarkPixelsInNoise) {
  models::RandomStream random(4, "tests.binarize");
  models::Image image(320, 240);
  for (auto& pixel : image.pixels) {
    pixel = static_cast<std::uint8_t>(std::clamp(60.0 + 3.0 * random.Normal(), 0.0, 255.0));
  }
  const models::Image dark = Binarize(image.View());
  EXPECT_EQ(std::count(dark.pixels.begin(), dark.pixels.end(), 255), 0);
}

TEST(Binarize, KeepsTheStrokesSolidAtTheLowestHeight) {
  const models::CameraModel camera;
  const models::LandingPad pad;
  const models::PadOutline outline(pad);
  const auto X_WC = tests::CameraAbovePad({0.0, 0.0, 0.15});
  const models::Image dark = Binarize(tests::RenderPad(camera, pad, X_WC).View());
  int black = 0, missed = 0, false_dark = 0;
  for (int v = 0; v < camera.height_px; v += 3) {
    for (int u = 0; u < camera.width_px; u += 3) {
      const Eigen::Vector3d ray_W = X_WC.linear() * *camera.Ray({u, v});
      const Eigen::Vector2d p_W = (0.15 / -ray_W.z() * ray_W).head<2>();
      if (p_W.norm() > 0.105) continue;
      const bool is_dark = dark.View().At(u, v) != 0;
      black += outline.IsBlack(p_W);
      missed += outline.IsBlack(p_W) && !is_dark;
      false_dark += !outline.IsBlack(p_W) && is_dark;
    }
  }
  EXPECT_GT(black, 4000);
  EXPECT_LT(missed, 0.03 * black);
  EXPECT_LT(false_dark, 0.03 * black);
}

TEST(Binarize, RejectsInvalidSettings) {
  EXPECT_THROW(BinarizeConfig{.window_px = 10}.Validate(), InputError);
  EXPECT_THROW(BinarizeConfig{.window_px = -1}.Validate(), InputError);
  EXPECT_THROW(BinarizeConfig{.window_px = 257}.Validate(), InputError);
  EXPECT_THROW(BinarizeConfig{.relative_margin = 1.0}.Validate(), InputError);
  EXPECT_THROW(BinarizeConfig{.absolute_margin = -1.0}.Validate(), InputError);
  EXPECT_NO_THROW(BinarizeConfig{}.Validate());
}

}  // namespace
}  // namespace touchdown::estimator::paper
