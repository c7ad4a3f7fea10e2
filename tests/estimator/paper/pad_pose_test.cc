#include "estimator/paper/pad_pose.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/angles.h"
#include "models/random_stream.h"
#include "models/vehicle.h"
#include "tests/support/synthetic_pad.h"

namespace touchdown::estimator::paper {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Direction of the H's strokes in the gravity-aligned image for a camera yaw: the inverse of CameraYaw.
double StrokeAngleFor(double psi_C) { return models::WrapToHalfPi(psi_C - models::kPi / 2.0); }

TEST(ReferenceNormal, IsUpInTheCameraFrame) {
  const Matrix3d R_BC = tests::NominalR_BC();
  for (const double roll : {-0.4, 0.0, 0.3}) {
    for (const double pitch : {-0.3, 0.0, 0.5}) {
      // Eq. 12 sets yaw to 0; the reference does not depend on it.
      const Matrix3d R_WB1 = models::RotationFromTaitBryan({roll, pitch, 0.0});
      const Matrix3d R_WB = models::RotationFromTaitBryan({roll, pitch, 1.1});
      const Vector3d eq13 = R_BC.transpose() * R_WB1.transpose() * Vector3d::UnitZ();
      EXPECT_LT((ReferenceNormal(R_WB.transpose() * -Vector3d::UnitZ(), R_BC) - eq13).norm(), 1e-12);
    }
  }
  EXPECT_LT((ReferenceNormal(-Vector3d::UnitZ(), R_BC) + Vector3d::UnitZ()).norm(), 1e-15);
}

TEST(ResolveByGravity, SelectsTheNormalNearerToTheReference) {
  const pad::CirclePose left{Vector3d(-0.2, 0.0, -1.0).normalized(), {0.0, 0.0, 1.0}};
  const pad::CirclePose right{Vector3d(0.2, 0.0, -1.0).normalized(), {0.0, 0.0, 1.1}};
  EXPECT_EQ(ResolveByGravity({left, right}, Vector3d(-0.01, 0.1, -1.0).normalized()), 0u);
  EXPECT_EQ(ResolveByGravity({left, right}, Vector3d(0.01, 0.1, -1.0).normalized()), 1u);
}

TEST(WrongBranchProbability, EqualsTheFractionOfWrongChoicesInSimulation) {
  const double half_angle = 0.03, sigma = 0.02;
  const std::array<pad::CirclePose, 2> poses{
      pad::CirclePose{Vector3d(-std::sin(half_angle), 0.0, -std::cos(half_angle)), {}},
      pad::CirclePose{Vector3d(std::sin(half_angle), 0.0, -std::cos(half_angle)), {}}};
  models::RandomStream random(2, "tests.pad_pose");
  double predicted = 0.0, wrong = 0.0;
  constexpr int kTrials = 20000;
  for (int i = 0; i < kTrials; ++i) {
    const std::size_t truth = random.Bernoulli(0.5) ? 1 : 0;
    const Vector3d error(0.0, sigma * random.Normal(), sigma * random.Normal());
    const Vector3d z_C = Eigen::AngleAxisd(error.z(), Vector3d::UnitY()) *
                         (Eigen::AngleAxisd(error.y(), Vector3d::UnitX()) * poses[truth].n_C);
    predicted += WrongBranchProbability(poses, z_C, sigma) / kTrials;
    wrong += (ResolveByGravity(poses, z_C) != truth) / static_cast<double>(kTrials);
  }
  EXPECT_GT(wrong, 0.03);
  EXPECT_NEAR(predicted, wrong, 0.005);
}

TEST(CameraRotation, IsTheRotationOfATiltedDownwardCamera) {
  for (const double tilt : {0.0, 1e-9, 1e-3, 0.2, 0.8}) {
    for (const double yaw : {-1.2, 0.0, 0.7}) {
      const Matrix3d R_WL = Eigen::AngleAxisd(yaw, Vector3d::UnitZ()) * tests::NominalR_BC();
      // A tilt about a horizontal axis is the shortest rotation to the level camera.
      const Matrix3d R_LC = models::RotationExp(tilt * Vector3d(0.6, 0.8, 0.0));
      const Matrix3d R_WC = R_WL * R_LC;
      const Vector3d n_C = R_WC.transpose() * Vector3d::UnitZ();
      EXPECT_LT((CameraRotation(n_C, yaw) - R_WC).norm(), 1e-9);
    }
  }
}

TEST(CameraRotation, IsWellConditionedAtTheLevelPose) {
  const Matrix3d level = CameraRotation(-Vector3d::UnitZ(), 0.3);
  for (int i = 0; i < 36; ++i) {
    const double direction = i * models::kPi / 18.0;
    const Vector3d n_C = Vector3d(1e-4 * std::cos(direction), 1e-4 * std::sin(direction), -1.0).normalized();
    const double rotation = models::RotationLog(CameraRotation(n_C, 0.3) * level.transpose()).norm();
    EXPECT_NEAR(rotation, 1e-4, 1e-6);
  }
}

TEST(CameraYaw, IsTheHeadingRelativeToTheStrokesWithin90Degrees) {
  const Matrix3d R_BC = tests::NominalR_BC();
  for (int deg = -89; deg <= 89; ++deg) {
    const double yaw = models::DegToRad(deg);
    EXPECT_NEAR(CameraYaw(StrokeAngleFor(yaw), R_BC), yaw, 1e-12);
    EXPECT_NEAR(CameraYaw(StrokeAngleFor(yaw) + models::kPi, R_BC), yaw, 1e-12);
  }
}

TEST(CameraYaw, IncreasesWhenTheStrokesRotateRightInTheImage) {
  // The strokes lean to the image's right, so the vehicle is rotated to the left.
  const double angle = std::atan2(-1.0, 0.5);
  EXPECT_GT(CameraYaw(angle, tests::NominalR_BC()), 0.1);
}

TEST(PadPose, IsExactForAnyPoseAndMounting) {
  models::RandomStream random(1, "tests.pad_pose");
  for (int i = 0; i < 200; ++i) {
    models::Vehicle vehicle;
    vehicle.camera.position_m = 0.1 * random.NormalVector3();
    vehicle.camera.misalignment_deg = {random.Uniform(-12.0, 12.0), random.Uniform(-12.0, 12.0),
                                       random.Uniform(-170.0, 170.0)};
    const Eigen::Isometry3d X_BC = vehicle.X_BC();

    // A camera at any yaw whose tilt is about a horizontal axis, so that the yaw of Eq. 15 is its own.
    const double camera_yaw = random.Uniform(-3.0, 3.0);
    const Matrix3d R_LC = models::RotationExp({random.Uniform(-0.5, 0.5), random.Uniform(-0.5, 0.5), 0.0});
    Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
    X_WC.linear() = Eigen::AngleAxisd(camera_yaw, Vector3d::UnitZ()) * tests::NominalR_BC() * R_LC;
    X_WC.translation() = Vector3d(random.Uniform(-0.5, 0.5), random.Uniform(-0.5, 0.5), random.Uniform(0.3, 2.0));
    Eigen::Isometry3d X_WB = X_WC * X_BC.inverse();
    const Vector3d forward_of_level = tests::NominalR_BC() * X_BC.linear().transpose().col(0);
    const double heading = camera_yaw + std::atan2(forward_of_level.y(), forward_of_level.x());
    if (std::abs(models::WrapToPi(heading)) > models::DegToRad(89.0)) {
      // The yaw is ambiguous by 180 degrees; the result is the solution within +-90 degrees.
      const Eigen::Isometry3d half_turn(Eigen::AngleAxisd(models::kPi, Vector3d::UnitZ()));
      X_WC = half_turn * X_WC;
      X_WB = half_turn * X_WB;
    }
    if (std::abs(std::cos(heading)) < 0.02) continue;

    const Vector3d n_C = X_WC.linear().transpose() * Vector3d::UnitZ();
    const Vector3d p_CW = X_WC.inverse().translation();
    const double psi_C = CameraYaw(StrokeAngleFor(camera_yaw), X_BC.linear());
    const Eigen::Isometry3d estimated = BodyPose(CameraRotation(n_C, psi_C), p_CW, X_BC);
    EXPECT_LT((estimated.matrix() - X_WB.matrix()).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace touchdown::estimator::paper
