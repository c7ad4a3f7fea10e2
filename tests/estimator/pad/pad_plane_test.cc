#include "estimator/pad/pad_plane.h"

#include <gtest/gtest.h>

#include "models/angles.h"
#include "tests/support/synthetic_pad.h"

namespace touchdown::estimator::pad {
namespace {

using Eigen::Vector2d;

class PadPlaneTest : public testing::Test {
 protected:
  const models::CameraModel camera_ = {};
  const UndistortTable undistort_{camera_};
  const Eigen::Isometry3d X_CW_ = tests::CameraAbovePad({0.05, -0.02, 0.6}, 0.4, models::DegToRad(25.0), 1.0).inverse();
  const CirclePose pose_{X_CW_.linear().col(2), X_CW_.translation()};
};

TEST_F(PadPlaneTest, ProjectsPointsAsTheCameraDoes) {
  for (const int reduction : {1, 2, 4}) {
    const DownsampledCamera view{camera_, undistort_, reduction};
    const PadPlane plane(pose_, view);
    for (const Vector2d& point : {Vector2d(0.0, 0.0), Vector2d(0.08, -0.03), Vector2d(-0.05, 0.07)}) {
      const auto raw = camera_.Project(plane.InCamera(point));
      const auto pixel = plane.PixelAt(point);
      ASSERT_TRUE(raw && pixel);
      EXPECT_LT((view.CameraPixel(*pixel) - *raw).norm(), 1e-9);
      EXPECT_LT((plane.PointAt(*pixel) - point).norm(), 1e-5);
      EXPECT_LT((plane.PointFromNormalized(plane.InCamera(point).hnormalized()) - point).norm(), 1e-12);
    }
  }
}

TEST_F(PadPlaneTest, LiesOnThePlaneOfTheRingWithTheOrientationOfW) {
  const DownsampledCamera view{camera_, undistort_, 1};
  const PadPlane plane(pose_, view);
  EXPECT_LT((plane.InCamera(Vector2d::Zero()) - X_CW_.translation()).norm(), 1e-12);
  const Eigen::Vector3d x = plane.InCamera({1, 0}) - plane.InCamera({0, 0});
  const Eigen::Vector3d y = plane.InCamera({0, 1}) - plane.InCamera({0, 0});
  EXPECT_LT((x.cross(y) - X_CW_.linear().col(2)).norm(), 1e-12);
}

TEST_F(PadPlaneTest, HasNoPixelForPointsBehindTheCamera) {
  const DownsampledCamera view{camera_, undistort_, 1};
  const CirclePose steep{Eigen::Vector3d(0.0, -0.8, -0.6), Eigen::Vector3d(0.0, 0.0, 0.3)};
  const PadPlane plane(steep, view);
  int not_visible = 0;
  for (const Vector2d& far : {Vector2d(9, 0), Vector2d(-9, 0), Vector2d(0, 9), Vector2d(0, -9)}) {
    not_visible += !plane.PixelAt(far);
  }
  EXPECT_GT(not_visible, 0);
}

}  // namespace
}  // namespace touchdown::estimator::pad
