#include "sim/render/floor_footprint.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/render/texture_filter.h"
#include "tests/support/rooms.h"

namespace touchdown::sim {
namespace {

using tests::CameraAt;

const PinholeView kView;  // Its corners lie 320 px and 240 px from the principal point, its focal length is 320 px.

TEST(FloorFootprint, HasOneDepthForACameraThatLooksStraightDown) {
  const auto footprint = FootprintOf(kView, CameraAt({0.3, -0.1, 1.2}));
  ASSERT_TRUE(footprint);
  EXPECT_NEAR(footprint->nearest_m, 1.2, 1e-12);
  EXPECT_NEAR(footprint->farthest_m, 1.2, 1e-12);
  // The image's top is towards +X of W, so that its width is along Y.
  EXPECT_NEAR(footprint->reach_m, 0.1 + 1.2, 1e-12);
}

TEST(FloorFootprint, FollowsTheTangentsOfTheViewsEdgesForATiltedCamera) {
  const double tilt = 0.3, height = 0.8;
  const auto footprint = FootprintOf(kView, CameraAt({0.0, 0.0, height}, {.roll = tilt}));
  ASSERT_TRUE(footprint);
  const double half_view = std::atan(320.0 / 320.0);
  EXPECT_NEAR(footprint->reach_m, height * std::tan(half_view + tilt), 1e-9);
  EXPECT_NEAR(footprint->farthest_m, height / std::cos(half_view + tilt) * std::cos(half_view), 1e-9);
  EXPECT_NEAR(footprint->nearest_m, height / std::cos(half_view - tilt) * std::cos(half_view), 1e-9);
}

TEST(FloorFootprint, IsNulloptForAViewOfTheHorizonOrFromBelowTheFloor) {
  EXPECT_TRUE(FootprintOf(kView, CameraAt({0.0, 0.0, 1.0}, {.roll = 0.78})));
  EXPECT_FALSE(FootprintOf(kView, CameraAt({0.0, 0.0, 1.0}, {.roll = 0.79})));
  EXPECT_FALSE(FootprintOf(kView, CameraAt({0.0, 0.0, 1.0}, {.roll = 3.0})));
  EXPECT_FALSE(FootprintOf(kView, CameraAt({0.0, 0.0, -0.1})));
  EXPECT_FALSE(FootprintOf(kView, CameraAt({0.0, 0.0, 0.0})));
}

TEST(MipLevel, SelectsTexelsAboutAsLongAsAPixel) {
  // At 0.32 m a pixel is 1 mm long.
  EXPECT_EQ(MipLevel(1000.0, 0.32, 320.0), 0);
  EXPECT_EQ(MipLevel(2000.0, 0.32, 320.0), 1);
  EXPECT_EQ(MipLevel(8000.0, 0.32, 320.0), 3);
  EXPECT_EQ(MipLevel(5000.0, 0.32, 320.0), 2);
  EXPECT_EQ(MipLevel(6000.0, 0.32, 320.0), 3);
  EXPECT_EQ(MipLevel(100.0, 0.32, 320.0), 0);
}

}  // namespace
}  // namespace touchdown::sim
