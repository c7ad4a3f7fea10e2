#include "scenarios/laboratory/calibration_corners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "models/angles.h"
#include "models/error.h"
#include "models/random_stream.h"
#include "scenarios/laboratory/calibration_camera.h"
#include "scenarios/laboratory/calibration_views.h"

namespace touchdown::laboratory {
namespace {

using Eigen::Isometry3d;

ImageCorners Projected(const Chessboard& board, const models::CameraModel& camera, const Isometry3d& X_EC) {
  ImageCorners corners;
  for (const Eigen::Vector3d& p_E : board.Corners()) corners.push_back(camera.Project(X_EC.inverse() * p_E).value());
  return corners;
}

models::CameraModel SomeCamera() {
  return {.width_px = 752,
          .height_px = 480,
          .fx_px = 458.7,
          .fy_px = 457.3,
          .cx_px = 367.2,
          .cy_px = 248.4,
          .k1 = -0.28,
          .k2 = 0.07};
}

TEST(CalibrationViews, ShowTheWholeBoardAndReachTheImageCorners) {
  const Chessboard board;
  for (const models::CameraModel& camera : {models::CameraModel(), SomeCamera()}) {
    models::RandomStream random(1, "test");
    Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
    for (const Isometry3d& X_EC : DrawCalibrationViews(board, camera, 27, random)) {
      EXPECT_GT(X_EC.translation().z(), 0.0) << "above the sheet";
      for (const Eigen::Vector2d& corner : Projected(board, camera, X_EC)) {
        EXPECT_TRUE(camera.Contains(corner));
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
      }
    }
    const Eigen::Vector2d size(camera.width_px, camera.height_px);
    const double reach_px = 0.2 * size.y();  // One square lies between the outermost corners and the edge of the board.
    EXPECT_LT(low.maxCoeff(), reach_px);
    EXPECT_LT((size - high).maxCoeff(), reach_px);
  }
}

TEST(CalibrationCorners, AreDetectedInTheOrderOfTheBoard) {
  const Chessboard board;
  const sim::CameraConfig camera;
  models::RandomStream random(2, "test");
  Isometry3d X_WE(Eigen::Translation3d(0.2, -0.1, 0.0));
  X_WE.linear() = models::RotationExp(Eigen::Vector3d(0.0, 0.0, 1.0));
  ChessboardCamera board_camera(board, X_WE, camera, 1);
  double worst_px = 0.0;
  for (const Isometry3d& X_EC : DrawCalibrationViews(board, camera.model, 5, random)) {
    const models::Image image = board_camera.Capture(X_WE * X_EC);
    const auto found = FindCorners(image.View(), board);
    ASSERT_TRUE(found);
    const ImageCorners truth = Projected(board, camera.model, X_EC);
    ASSERT_EQ(found->size(), truth.size());
    for (std::size_t i = 0; i < truth.size(); ++i) worst_px = std::max(worst_px, ((*found)[i] - truth[i]).norm());
  }
  EXPECT_LT(worst_px, 0.3);
}

TEST(CalibrationCorners, AreNotFoundWithoutABoard) {
  EXPECT_FALSE(FindCorners(models::Image(640, 480, 128).View(), Chessboard()));
}

class CameraFitTest : public ::testing::Test {
 protected:
  void AddViews(const models::CameraModel& camera, int count) {
    models::RandomStream random(3, "test");
    poses_ = DrawCalibrationViews(board_, camera, count, random);
    for (const Isometry3d& X_EC : poses_) views_.push_back(Projected(board_, camera, X_EC));
  }
  CameraFit Fit(LensTerms terms = LensTerms::kRadial) const { return FitCamera(views_, board_, 752, 480, terms); }

  const Chessboard board_ = {};
  std::vector<Isometry3d> poses_;
  std::vector<ImageCorners> views_;
};

TEST_F(CameraFitTest, RecoversTheCameraFromExactCorners) {
  const models::CameraModel camera = SomeCamera();
  AddViews(camera, 9);
  const CameraFit fit = Fit();
  EXPECT_LT(fit.rms_px, 1e-3);
  EXPECT_NEAR(fit.model.fx_px, camera.fx_px, 0.01);
  EXPECT_NEAR(fit.model.fy_px, camera.fy_px, 0.01);
  EXPECT_NEAR(fit.model.cx_px, camera.cx_px, 0.01);
  EXPECT_NEAR(fit.model.cy_px, camera.cy_px, 0.01);
  EXPECT_NEAR(fit.model.k1, camera.k1, 1e-4);
  EXPECT_NEAR(fit.model.k2, camera.k2, 2e-4);
  EXPECT_EQ(fit.model.k3, 0.0);
  EXPECT_EQ(fit.model.p1, 0.0);
  ASSERT_EQ(fit.X_EC.size(), poses_.size());
  for (std::size_t i = 0; i < poses_.size(); ++i) EXPECT_TRUE(fit.X_EC[i].value().isApprox(poses_[i], 1e-4));
}

TEST_F(CameraFitTest, EstimatesTangentialTerms) {
  models::CameraModel camera = SomeCamera();
  camera.p1 = 0.002;
  camera.p2 = -0.001;
  AddViews(camera, 12);
  EXPECT_GT(Fit().rms_px, 0.05) << "radial terms are not sufficient";
  const CameraFit fit = Fit(LensTerms::kAll);
  EXPECT_LT(fit.rms_px, 1e-3);
  EXPECT_NEAR(fit.model.p1, camera.p1, 2e-5);
  EXPECT_NEAR(fit.model.p2, camera.p2, 2e-5);
}

TEST_F(CameraFitTest, ExcludesAViewWithAWrongCorner) {
  AddViews(SomeCamera(), 9);
  models::RandomStream random(4, "noise");
  for (ImageCorners& view : views_) {
    for (Eigen::Vector2d& corner : view) corner += 0.05 * Eigen::Vector2d(random.Normal(), random.Normal());
  }
  views_[4][7] += Eigen::Vector2d(9.0, 4.0);
  const CameraFit fit = Fit();
  for (std::size_t i = 0; i < views_.size(); ++i) EXPECT_EQ(fit.X_EC[i].has_value(), i != 4) << i;
  EXPECT_LT(fit.rms_px, 0.1);
}

TEST_F(CameraFitTest, RejectsTwoViews) {
  AddViews(SomeCamera(), 2);
  EXPECT_THROW(Fit(), InputError);
}

}  // namespace
}  // namespace touchdown::laboratory
