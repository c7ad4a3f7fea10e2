#include "estimator/pad/undistort_table.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "models/error.h"
#include "models/random_stream.h"

namespace touchdown::estimator::pad {
namespace {

using Eigen::Vector2d;

Vector2d Undistorted(const models::CameraModel& camera, const Vector2d& pixel) {
  return camera.PixelFromNormalized(*camera.Undistort(camera.NormalizedFromPixel(pixel)));
}

TEST(UndistortTable, IsAccurateTo1000thOfAPixel) {
  models::CameraModel strong;
  strong.k1 = -0.283;
  strong.k2 = 0.074;
  models::RandomStream random(1, "tests.undistort_table");
  for (const models::CameraModel& camera : {models::CameraModel(), strong}) {
    const UndistortTable table(camera);
    const double tolerance = camera.k1 < -0.2 ? 0.005 : 0.001;
    for (int i = 0; i < 5000; ++i) {
      const Vector2d pixel(random.Uniform(0.0, 639.0), random.Uniform(0.0, 479.0));
      EXPECT_LT((table.At(pixel) - Undistorted(camera, pixel)).norm(), tolerance) << pixel.transpose();
    }
  }
}

TEST(UndistortTable, InvertsTheCameraModel) {
  const models::CameraModel camera;
  const UndistortTable table(camera);
  const Eigen::Vector3d p_C(0.4, -0.3, 0.9);
  const auto raw = camera.Project(p_C);
  ASSERT_TRUE(raw);
  EXPECT_LT((table.At(*raw) - camera.PixelFromNormalized(p_C.hnormalized())).norm(), 0.001);
}

TEST(UndistortTable, IsTheIdentityForAPinholeCamera) {
  models::CameraModel camera;
  camera.k1 = camera.k2 = 0.0;
  const UndistortTable table(camera);
  for (const Vector2d& pixel : {Vector2d(0.0, 0.0), Vector2d(639.0, 479.0), Vector2d(12.3, 456.7)}) {
    EXPECT_LT((table.At(pixel) - pixel).norm(), 1e-9);
  }
}

TEST(UndistortTable, ExtrapolatesToTheImageBorder) {
  const models::CameraModel camera;
  const UndistortTable table(camera);
  for (const Vector2d& pixel : {Vector2d(-0.5, -0.5), Vector2d(639.5, 479.5), Vector2d(-0.5, 300.0)}) {
    EXPECT_LT((table.At(pixel) - Undistorted(camera, pixel)).norm(), 0.01);
  }
}

TEST(UndistortTable, AcceptsOnePixelAndRejectsADistortionThatFolds) {
  models::CameraModel camera;
  camera.width_px = camera.height_px = 1;
  camera.cx_px = camera.cy_px = 0.0;
  EXPECT_LT(UndistortTable(camera).At({0.0, 0.0}).norm(), 1e-9);
  models::CameraModel folding;
  folding.k1 = -0.6;
  EXPECT_THROW(UndistortTable{folding}, InputError);
}

}  // namespace
}  // namespace touchdown::estimator::pad
