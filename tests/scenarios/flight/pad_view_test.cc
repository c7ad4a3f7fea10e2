#include "scenarios/flight/pad_view.h"

#include <gtest/gtest.h>

#include "models/angles.h"
#include "models/vehicle.h"

namespace touchdown::scenarios {
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

TEST(NearerTwin, TurnsThePoseAboutThePadWhenItsYawIsHalfATurnAway) {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.translation() << 0.3, -0.2, 1.0;
  X_WB.linear() = models::RotationFromTaitBryan({0.1, -0.05, models::DegToRad(80)});
  EXPECT_TRUE(NearerTwin(X_WB, models::DegToRad(20)).isApprox(X_WB));
  const Eigen::Isometry3d twin = NearerTwin(X_WB, models::DegToRad(-95));
  EXPECT_TRUE(twin.translation().isApprox(Eigen::Vector3d(-0.3, 0.2, 1.0)));
  const models::TaitBryan angles = models::TaitBryanFromRotation(twin.linear());
  EXPECT_NEAR(angles.roll, 0.1, 1e-12);
  EXPECT_NEAR(angles.pitch, -0.05, 1e-12);
  EXPECT_NEAR(models::RadToDeg(angles.yaw), -100.0, 1e-9);
}

}  // namespace
}  // namespace touchdown::scenarios
