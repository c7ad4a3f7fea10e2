#include "scenarios/runner/pad_view.h"

#include <gtest/gtest.h>

#include "models/vehicle.h"

namespace touchdown::runner {
namespace {

Eigen::Isometry3d CameraAt(double x, double y, double z) {
  models::Vehicle vehicle;
  vehicle.camera.position_m.setZero();
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.translation() << x, y, z;
  return X_WB * vehicle.X_BC();
}

TEST(WholeRingInView, EndsWhereTheRingMeetsTheImagesEdge) {
  models::CameraModel camera;
  camera.k1 = camera.k2 = 0.0;
  const models::LandingPad pad;
  // 240 px of half height at f = 320 px: a ring of 90 mm fits from 120 mm on.
  EXPECT_FALSE(WholeRingInView(camera, pad, CameraAt(0, 0, 0.119)));
  EXPECT_TRUE(WholeRingInView(camera, pad, CameraAt(0, 0, 0.121)));
  // At 1 m, the pad may be 750 - 90 mm off along the image's height and 1000 - 90 mm along its width.
  EXPECT_TRUE(WholeRingInView(camera, pad, CameraAt(0.655, 0, 1)));
  EXPECT_FALSE(WholeRingInView(camera, pad, CameraAt(0.665, 0, 1)));
  EXPECT_TRUE(WholeRingInView(camera, pad, CameraAt(0, 0.905, 1)));
  EXPECT_FALSE(WholeRingInView(camera, pad, CameraAt(0, 0.915, 1)));
}

TEST(WholeRingInView, FollowsTheDistortion) {
  models::CameraModel barrel;
  barrel.k1 = -0.10;
  barrel.k2 = 0.0;
  const models::LandingPad pad;
  EXPECT_TRUE(WholeRingInView(barrel, pad, CameraAt(0.70, 0, 1)));
}

TEST(WholeRingInView, IsFalseForAPadBehindTheCamera) {
  EXPECT_FALSE(WholeRingInView(models::CameraModel(), models::LandingPad(), CameraAt(0, 0, -1)));
}

}  // namespace
}  // namespace touchdown::runner
