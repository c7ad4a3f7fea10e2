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

TEST(WholeRingInView, IsFalseWhenRingCrossesImageEdge) {
  models::CameraModel camera;
  camera.k1 = camera.k2 = 0.0;
  const models::LandingPad pad;
  // Half height 240 px, f = 320 px: a ring with a radius of 90 mm fits at distances from 120 mm.
  EXPECT_FALSE(WholeRingInView(camera, pad, CameraAt(0, 0, 0.119)));
  EXPECT_TRUE(WholeRingInView(camera, pad, CameraAt(0, 0, 0.121)));
  // At 1 m, the offset may be 750 - 90 mm along the image height and 1000 - 90 mm along the image width.
  EXPECT_TRUE(WholeRingInView(camera, pad, CameraAt(0.655, 0, 1)));
  EXPECT_FALSE(WholeRingInView(camera, pad, CameraAt(0.665, 0, 1)));
  EXPECT_TRUE(WholeRingInView(camera, pad, CameraAt(0, 0.905, 1)));
  EXPECT_FALSE(WholeRingInView(camera, pad, CameraAt(0, 0.915, 1)));
}

TEST(WholeRingInView, IncludesDistortion) {
  models::CameraModel barrel;
  barrel.k1 = -0.10;
  barrel.k2 = 0.0;
  const models::LandingPad pad;
  EXPECT_TRUE(WholeRingInView(barrel, pad, CameraAt(0.70, 0, 1)));
}

TEST(WholeRingInView, IsFalseForPadBehindCamera) {
  EXPECT_FALSE(WholeRingInView(models::CameraModel(), models::LandingPad(), CameraAt(0, 0, -1)));
}

}  // namespace
}  // namespace touchdown::runner
