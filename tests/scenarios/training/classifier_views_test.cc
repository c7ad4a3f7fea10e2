#include "scenarios/training/classifier_views.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/angles.h"
#include "models/error.h"
#include "tests/support/empty_room.h"

namespace touchdown::training {
namespace {

constexpr int kViews = 200;

const models::CameraModel kCamera;

GroundShape RotatedShape() {
  GroundShape shape;
  shape.position_m = {0.4, -0.2};
  shape.yaw = 0.7;
  shape.radius_m = 0.09;
  return shape;
}

std::vector<View> DrawViews(const ViewConfig& config, std::uint64_t seed = 1) {
  models::RandomStream random(seed, "tests.classifier_views");
  std::vector<View> views;
  for (int i = 0; i < kViews; ++i)
    views.push_back(DrawView(config, tests::EmptyRoom(), RotatedShape(), kCamera, random));
  return views;
}

double TiltOf(const View& view) { return std::acos(-view.X_WC.linear()(2, 2)); }

/// Horizontal angle between the up direction of the image and the nearest axis of the shape, rad.
double OffAxis(const View& view) {
  const Eigen::Vector3d up_W = -view.X_WC.linear().col(1);
  return std::abs(std::remainder(std::atan2(up_W.y(), up_W.x()) - RotatedShape().yaw, models::kPi / 2.0));
}

TEST(DrawView, HoversLevelAtRestInFocusAndAligned) {
  for (const View& view : DrawViews({.hovering_fraction = 1.0})) {
    EXPECT_LE(TiltOf(view), models::DegToRad(3.01));
    EXPECT_LT(OffAxis(view), models::DegToRad(9.0));
    EXPECT_EQ(view.v_WC.norm() + view.w_WC_C.norm() + view.defocus_px, 0.0);
  }
}

TEST(DrawView, TiltsRotatesMovesAndDefocusesOtherwise) {
  double max_tilt = 0.0, fastest = 0.0, off_axis = 0.0;
  int defocused = 0;
  const ViewConfig config{.hovering_fraction = 0.0};
  for (const View& view : DrawViews(config)) {
    EXPECT_LE(TiltOf(view), models::DegToRad(config.max_tilt_deg + 0.01));
    max_tilt = std::max(max_tilt, TiltOf(view));
    fastest = std::max(fastest, view.v_WC.norm());
    off_axis += OffAxis(view) / kViews;
    defocused += view.defocus_px > 0.0 ? 1 : 0;
  }
  EXPECT_GT(max_tilt, models::DegToRad(45.0));
  EXPECT_GT(fastest, 0.7);
  EXPECT_NEAR(off_axis, models::DegToRad(22.5), models::DegToRad(4.0));
  EXPECT_NEAR(defocused, 0.5 * kViews, kViews / 8.0);
}

TEST(DrawView, ShowsTheShapeWithinTheDistanceRange) {
  const ViewConfig config;
  for (const View& view : DrawViews(config)) {
    const Eigen::Vector3d p_C = view.X_WC.inverse() * Eigen::Vector3d(0.4, -0.2, 0.0);
    const auto pixel = kCamera.Project(p_C);
    ASSERT_TRUE(pixel);
    EXPECT_TRUE(kCamera.Contains(*pixel));
    EXPECT_GE(p_C.norm(), 0.999 * config.min_distance_m);
    EXPECT_LE(p_C.norm(), 1.001 * config.max_distance_m);
    EXPECT_GT(view.X_WC.translation().z(), 0.0);
  }
}

TEST(DrawView, GivesTheSameViewsForTheSameSeed) {
  const std::vector<View> first = DrawViews({}), again = DrawViews({}), other = DrawViews({}, 2);
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_TRUE(first[i].X_WC.isApprox(again[i].X_WC, 0.0));
  EXPECT_FALSE(first.front().X_WC.isApprox(other.front().X_WC));
}

TEST(ViewConfig, RejectsEmptyRangesAndInvalidFractions) {
  EXPECT_NO_THROW(ViewConfig{}.Validate());
  EXPECT_THROW((ViewConfig{.min_distance_m = 2.0, .max_distance_m = 1.0}.Validate()), InputError);
  EXPECT_THROW((ViewConfig{.hovering_fraction = -0.1}.Validate()), InputError);
  EXPECT_THROW((ViewConfig{.hovering_fraction = 1.1}.Validate()), InputError);
  EXPECT_THROW((ViewConfig{.noise_sigmas = {}}.Validate()), InputError);
}

}  // namespace
}  // namespace touchdown::training
