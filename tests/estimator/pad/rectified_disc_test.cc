#include "estimator/pad/rectified_disc.h"

#include <gtest/gtest.h>

#include "models/angles.h"
#include "tests/support/synthetic_pad.h"

namespace touchdown::estimator::pad {
namespace {

using Eigen::Vector2d;

class RectifiedDiscTest : public testing::Test {
 protected:
  PadPlane Plane() const {
    const Eigen::Isometry3d X_CW = X_WC_.inverse();
    return PadPlane({X_CW.linear().col(2), X_CW.translation()}, {camera_, undistort_, 1});
  }

  /// Image of a floor whose gray value increases along the plane's first coordinate.
  models::Image GrayRamp() const {
    const PadPlane plane = Plane();
    const Eigen::Vector3d x_W = X_WC_.linear() * (plane.InCamera({1, 0}) - plane.InCamera({0, 0}));
    tests::PadAppearance appearance{.samples_per_side = 2};
    appearance.paint = [&](const Vector2d& p) { return std::optional(120.0 + 600.0 * p.dot(x_W.head<2>())); };
    return tests::RenderPad(camera_, {}, X_WC_, appearance);
  }

  models::CameraModel camera_;
  UndistortTable undistort_{camera_};
  Eigen::Isometry3d X_WC_ = tests::CameraAbovePad({0.05, -0.03, 0.5}, 0.4, models::DegToRad(30.0), 1.0);
};

TEST_F(RectifiedDiscTest, RectifiesTheImageOntoThePlane) {
  const auto disc = RectifiedDisc::Of(GrayRamp().View(), Plane(), 0.08);
  ASSERT_TRUE(disc);
  EXPECT_NEAR(disc->cell_m(), 0.0025, 1e-12);
  for (int row = 0; row < RectifiedDisc::kCells; row += 3) {
    for (int column = 0; column < RectifiedDisc::kCells; column += 3) {
      if (!disc->Contains(column, row)) continue;
      EXPECT_NEAR(disc->gray()(row, column), 120.0 + 600.0 * disc->CellCenter(column, row).x(), 1.0);
    }
  }
}

TEST_F(RectifiedDiscTest, ReturnsNulloptForADiscPartlyOutsideTheImage) {
  const models::Image image = GrayRamp();
  EXPECT_TRUE(RectifiedDisc::Of(image.View(), Plane(), 0.15));
  EXPECT_FALSE(RectifiedDisc::Of(image.View(), Plane(), 1.0));
  X_WC_ = tests::CameraAbovePad({0.0, 0.0, 0.3}, 0.0, models::DegToRad(80.0), 1.0);
  EXPECT_FALSE(RectifiedDisc::Of(image.View(), Plane(), 0.08)) << "outside the image";
}

TEST_F(RectifiedDiscTest, NormalizesUnevenIllumination) {
  tests::PadAppearance appearance{.samples_per_side = 2};
  const auto lit = [](double slope) {
    return [slope](const Vector2d& p) {
      const bool dark =
          (static_cast<int>(std::floor(p.x() / 0.02)) + static_cast<int>(std::floor(p.y() / 0.02))) % 2 == 0;
      return std::optional((dark ? 30.0 : 120.0) * (1.0 + slope * p.x()));
    };
  };
  std::vector<Cells> normalized;
  for (const double slope : {0.0, 7.0}) {
    appearance.paint = lit(slope);
    const auto disc = RectifiedDisc::Of(tests::RenderPad(camera_, {}, X_WC_, appearance).View(), Plane(), 0.06);
    ASSERT_TRUE(disc);
    Cells cells = disc->ContrastNormalized(1.0);
    for (int row = 0; row < RectifiedDisc::kCells; ++row) {
      for (int column = 0; column < RectifiedDisc::kCells; ++column) {
        if (!disc->Contains(column, row)) cells(row, column) = 0.0F;
      }
    }
    normalized.push_back(cells);
  }
  const double zncc =
      (normalized[0] * normalized[1]).sum() / std::sqrt(normalized[0].square().sum() * normalized[1].square().sum());
  EXPECT_GT(zncc, 0.97);
}

TEST_F(RectifiedDiscTest, ComputesAWeightedLocalMean) {
  Cells values = Cells::Constant(RectifiedDisc::kCells, RectifiedDisc::kCells, 7.0F), weights = values;
  values.leftCols(10) = 1000.0F;
  weights.leftCols(10) = 0.0F;
  const Cells mean = RectifiedDisc::LocalMean(values, weights);
  EXPECT_NEAR(mean(30, 12), 7.0F, 1e-3F);
  EXPECT_NEAR(mean(60, 60), 7.0F, 1e-3F);
}

}  // namespace
}  // namespace touchdown::estimator::pad
