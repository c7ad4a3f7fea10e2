#include <gtest/gtest.h>

#include <cmath>

#include "estimator/paper/paper_estimator.h"
#include "models/angles.h"
#include "models/vehicle.h"
#include "tests/support/synthetic_pad.h"

namespace touchdown::estimator::paper {
namespace {

using Eigen::Vector3d;

struct Conditions {
  double distance_m = 1.0;
  double tilt_deg = 0.0;        ///< Tilt about a random horizontal axis, with the pad near the image center.
  double tilt_sigma_deg = 0.0;  ///< Standard deviation added to tilt_deg.
  pad::ContourPoints contour_points = pad::ContourPoints::kSubpixel;
};

struct Accuracy {
  int detected = 0;                                                                   ///< Number of poses.
  double camera_frame_m = 0.0, xy_m = 0.0, z_m = 0.0, tilt_deg = 0.0, yaw_deg = 0.0;  ///< RMSE.
  Eigen::Matrix<double, 6, 1> normalized_squares = Eigen::Matrix<double, 6, 1>::Zero();
};

constexpr int kPoses = 25;

/// RMSE over random poses with pixel noise of 3 of 255, a gravity direction error of 0.5 degrees and the default lens.
Accuracy AccuracyIn(const Conditions& conditions) {
  const EstimatorSetup setup{.camera = {}, .pad = {}, .X_BC = models::Vehicle().X_BC(), .time = {}};
  PaperEstimatorConfig config;
  config.search.edges.contour_points = conditions.contour_points;
  models::RandomStream random(1, "tests.paper_accuracy");
  PaperEstimator estimator(setup, config);
  Accuracy sum;
  for (int i = 0; i < kPoses; ++i) {
    const double tilt = models::DegToRad(conditions.tilt_deg + conditions.tilt_sigma_deg * random.Normal());
    Eigen::Isometry3d X_WC = tests::CameraAbovePad(Vector3d::Zero(), models::DegToRad(5.0) * random.Normal(), tilt,
                                                   random.Uniform(-models::kPi, models::kPi));
    X_WC.translation() = -conditions.distance_m * X_WC.linear().col(2) +
                         Vector3d(random.Uniform(-0.05, 0.05), random.Uniform(-0.05, 0.05), 0.0);
    const Eigen::Isometry3d X_WB = X_WC * setup.X_BC.inverse();
    const auto image =
        tests::RenderPad(setup.camera, setup.pad, X_WC, {.noise_sigma = 3.0, .lens_blur_sigma_px = 0.5}, &random);
    const Vector3d gravity_B =
        models::RotationExp(models::DegToRad(0.5) * random.NormalVector3()) * tests::GravityIn(X_WB);
    const FrameResult result = estimator.Estimate(image.View(), i, gravity_B);
    if (!result.pose) continue;
    ++sum.detected;

    const Eigen::Isometry3d& X = result.pose->X_WB;
    const Vector3d position = X.translation() - X_WB.translation();
    const Vector3d rotation = models::RotationLog(X.linear() * X_WB.linear().transpose());
    const Vector3d up = X.linear().row(2), true_up = X_WB.linear().row(2);
    sum.camera_frame_m += ((X * setup.X_BC).inverse().translation() - X_WC.inverse().translation()).squaredNorm();
    sum.xy_m += position.head<2>().squaredNorm();
    sum.z_m += position.z() * position.z();
    sum.tilt_deg += std::pow(models::RadToDeg(std::asin(up.cross(true_up).norm())), 2);
    sum.yaw_deg += std::pow(models::RadToDeg(models::TaitBryanFromRotation(X.linear()).yaw -
                                             models::TaitBryanFromRotation(X_WB.linear()).yaw),
                            2);
    Eigen::Matrix<double, 6, 1> error;
    error << position, rotation;
    sum.normalized_squares += error.cwiseAbs2().cwiseQuotient(result.pose->covariance.diagonal()) / kPoses;
  }
  for (double* square : {&sum.camera_frame_m, &sum.xy_m, &sum.z_m, &sum.tilt_deg, &sum.yaw_deg}) {
    *square = std::sqrt(*square / std::max(sum.detected, 1));
  }
  return sum;
}

TEST(PaperAccuracy, NearHoverAtHalfAMeter) {
  const Accuracy accuracy = AccuracyIn({.distance_m = 0.5, .tilt_sigma_deg = 2.0});
  EXPECT_EQ(accuracy.detected, kPoses);
  EXPECT_LT(accuracy.camera_frame_m, 0.0007);
  EXPECT_LT(accuracy.xy_m, 0.005);
  EXPECT_LT(accuracy.tilt_deg, 0.5);
  EXPECT_LT(accuracy.yaw_deg, 1.0);
}

TEST(PaperAccuracy, NearHoverAtAMeter) {
  const Accuracy accuracy = AccuracyIn({.distance_m = 1.0, .tilt_sigma_deg = 2.0});
  EXPECT_EQ(accuracy.detected, kPoses);
  EXPECT_LT(accuracy.camera_frame_m, 0.0015);
  EXPECT_LT(accuracy.xy_m, 0.025);
  EXPECT_LT(accuracy.tilt_deg, 1.3);
  EXPECT_LT(accuracy.yaw_deg, 1.5);
}

TEST(PaperAccuracy, NearHoverAtTwoMeters) {
  const Accuracy accuracy = AccuracyIn({.distance_m = 2.0, .tilt_sigma_deg = 2.0});
  EXPECT_GE(accuracy.detected, kPoses - 1);
  EXPECT_LT(accuracy.camera_frame_m, 0.015);
  EXPECT_LT(accuracy.xy_m, 0.12);
  EXPECT_LT(accuracy.tilt_deg, 3.5);
  EXPECT_LT(accuracy.yaw_deg, 2.5);
}

TEST(PaperAccuracy, TiltedBy20DegreesAtAMeter) {
  const Accuracy accuracy = AccuracyIn({.distance_m = 1.0, .tilt_deg = 20.0});
  EXPECT_EQ(accuracy.detected, kPoses);
  EXPECT_LT(accuracy.camera_frame_m, 0.001);
  EXPECT_LT(accuracy.tilt_deg, 0.2);
  EXPECT_LT(accuracy.yaw_deg, 4.0);  // Not rectified.
}

TEST(PaperAccuracy, TiltedBy40DegreesAtAMeter) {
  const Accuracy accuracy = AccuracyIn({.distance_m = 1.0, .tilt_deg = 40.0});
  EXPECT_EQ(accuracy.detected, kPoses);
  EXPECT_LT(accuracy.camera_frame_m, 0.002);
  EXPECT_LT(accuracy.tilt_deg, 0.2);
  EXPECT_LT(accuracy.yaw_deg, 15.0);  // Not rectified.
}

TEST(PaperAccuracy, IsTwiceAsGoodWithSubpixelContours) {
  const Accuracy subpixel = AccuracyIn({.distance_m = 1.0, .tilt_sigma_deg = 2.0});
  const Accuracy integer =
      AccuracyIn({.distance_m = 1.0, .tilt_sigma_deg = 2.0, .contour_points = pad::ContourPoints::kInteger});
  EXPECT_LT(subpixel.xy_m, 0.5 * integer.xy_m);
  EXPECT_LT(subpixel.z_m, 0.5 * integer.z_m);
  EXPECT_GT(integer.xy_m, 0.02);
}

TEST(PaperAccuracy, HasConsistentCovariances) {
  for (const Conditions& conditions :
       {Conditions{.distance_m = 1.0, .tilt_sigma_deg = 2.0}, Conditions{.distance_m = 1.0, .tilt_deg = 20.0},
        Conditions{.distance_m = 1.6, .tilt_sigma_deg = 4.0}}) {
    const Accuracy accuracy = AccuracyIn(conditions);
    // The expectation is 1 for a correct covariance. The limits are wide because of systematic errors.
    for (int i = 0; i < 6; ++i) {
      EXPECT_LT(accuracy.normalized_squares(i), 4.0) << i;
      EXPECT_GT(accuracy.normalized_squares(i), 0.05) << i;
    }
  }
}

}  // namespace
}  // namespace touchdown::estimator::paper
