#include "sim/sensors/imager.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "tests/support/rooms.h"

namespace touchdown::sim {
namespace {

const models::CameraModel kCamera{
    .width_px = 160, .height_px = 120, .fx_px = 80, .fy_px = 80, .cx_px = 79.5, .cy_px = 59.5};

/// Standard deviation of the difference of two images.
double StddevOfDifference(const models::Image& a, const models::Image& b) {
  double sum = 0.0, sum_of_squares = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const double difference = double(a.pixels[i]) - double(b.pixels[i]);
    sum += difference;
    sum_of_squares += difference * difference;
  }
  const auto count = static_cast<double>(a.pixels.size());
  return std::sqrt(sum_of_squares / count - sum * sum / (count * count));
}

TEST(Imager, AddsTheNoiseOfTheChosenLevelToOneExposure) {
  const tests::Room room(tests::EmptyRoomConfig());
  Imager imager(*room.model, CameraOptics(kCamera), {0.0, 5.0}, 1);
  const FineImage exposed = imager.Expose(*room.data, std::array{tests::CameraAt({0.0, 0.0, 0.5})});
  const models::Image clean = imager.AddNoise(exposed, 0);
  EXPECT_EQ(imager.AddNoise(exposed, 0).pixels, clean.pixels);
  const models::Image noisy = imager.AddNoise(exposed, 1);
  EXPECT_NEAR(StddevOfDifference(noisy, clean), 5.0, 0.3);
  EXPECT_NEAR(StddevOfDifference(imager.AddNoise(exposed, 1), noisy), 5.0 * std::sqrt(2.0), 0.5)
      << "different noise in each call";
  EXPECT_THROW(imager.AddNoise(exposed, 2), std::out_of_range);
}

TEST(Imager, CapturesWithTheFirstNoiseLevel) {
  const tests::Room room(tests::EmptyRoomConfig());
  const std::array path{tests::CameraAt({0.0, 0.0, 0.5}), tests::CameraAt({0.01, 0.0, 0.5})};
  Imager imager(*room.model, CameraOptics(kCamera), {3.0, 7.0}, 4), same(*room.model, CameraOptics(kCamera), {3.0}, 4);
  const models::Image image = imager.Capture(*room.data, path);
  EXPECT_EQ(image.width, kCamera.width_px);
  EXPECT_EQ(image.height, kCamera.height_px);
  EXPECT_EQ(same.AddNoise(same.Expose(*room.data, path)).pixels, image.pixels);
}

TEST(Imager, AveragesAnOversampledViewOverThePixels) {
  SceneConfig config = tests::EmptyRoomConfig();
  config.objects = 12;
  const tests::Room room(config, 3);
  const std::array pose{tests::CameraAt({0.0, 0.0, 2.0})};
  Imager plain(*room.model, CameraOptics(kCamera), {0.0}, 1), fine(*room.model, CameraOptics(kCamera), {0.0}, 1, 4);
  const models::Image coarse = plain.Capture(*room.data, pose), averaged = fine.Capture(*room.data, pose);
  ASSERT_EQ(averaged.pixels.size(), coarse.pixels.size());
  EXPECT_NE(averaged.pixels, coarse.pixels);
  EXPECT_LT(StddevOfDifference(averaged, coarse), 6.0) << "the same view at the same pixels";
}

}  // namespace
}  // namespace touchdown::sim
