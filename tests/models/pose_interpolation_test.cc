#include "models/pose_interpolation.h"

#include <gtest/gtest.h>

#include "models/angles.h"

namespace touchdown::models {
namespace {

Eigen::Isometry3d PoseOf(const Eigen::Vector3d& rotation_vector, const Eigen::Vector3d& position) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = RotationExp(rotation_vector);
  X.translation() = position;
  return X;
}

TEST(InterpolatePose, MovesStraightAndRotatesAboutOneAxisAtAConstantRate) {
  const Eigen::Isometry3d from = PoseOf({0.2, -0.1, 0.5}, {1, 2, 3}), to = PoseOf({-0.4, 0.3, 2.0}, {2, 0, 3});
  EXPECT_TRUE(InterpolatePose(from, to, 0.0).isApprox(from));
  EXPECT_TRUE(InterpolatePose(from, to, 1.0).isApprox(to));
  const Eigen::Isometry3d between = InterpolatePose(from, to, 0.25);
  EXPECT_TRUE(between.translation().isApprox(Eigen::Vector3d(1.25, 1.5, 3.0)));
  const Eigen::Vector3d whole = RotationLog(from.linear().transpose() * to.linear());
  EXPECT_TRUE(RotationLog(from.linear().transpose() * between.linear()).isApprox(0.25 * whole));
}

TEST(InterpolatePose, RotatesByTheSmallerAngle) {
  const Eigen::Isometry3d from = PoseOf({0, 0, 3.0}, {0, 0, 0}), to = PoseOf({0, 0, -3.0}, {0, 0, 0});
  EXPECT_NEAR(std::abs(TaitBryanFromRotation(InterpolatePose(from, to, 0.5).linear()).yaw), kPi, 1e-9);
}

}  // namespace
}  // namespace touchdown::models
