#include "models/angles.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "models/random_stream.h"

namespace touchdown::models {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

bool IsRotation(const Matrix3d& R) {
  return (R * R.transpose()).isApprox(Matrix3d::Identity(), 1e-12) && std::abs(R.determinant() - 1.0) < 1e-12;
}

Vector3d UnitVector(RandomStream& random) { return random.NormalVector3().normalized(); }

TEST(TaitBryan, PositiveRollLowersTheRightSide) {
  const Vector3d right = RotationFromTaitBryan({.roll = 0.2}) * -Vector3d::UnitY();
  EXPECT_NEAR(right.z(), -std::sin(0.2), 1e-15);
}

TEST(TaitBryan, PositivePitchLowersTheNose) {
  const Vector3d nose = RotationFromTaitBryan({.pitch = 0.2}) * Vector3d::UnitX();
  EXPECT_NEAR(nose.z(), -std::sin(0.2), 1e-15);
}

TEST(TaitBryan, PositiveYawTurnsLeft) {
  const Vector3d nose = RotationFromTaitBryan({.yaw = 0.2}) * Vector3d::UnitX();
  EXPECT_NEAR(nose.y(), std::sin(0.2), 1e-15);
}

TEST(TaitBryan, RotatesByRollThenPitchThenYawInTheWorld) {
  const TaitBryan angles{.roll = 0.3, .pitch = -0.4, .yaw = 1.1};
  const Matrix3d expected = RotationFromTaitBryan({.yaw = 1.1}) * RotationFromTaitBryan({.pitch = -0.4}) *
                            RotationFromTaitBryan({.roll = 0.3});
  EXPECT_TRUE(RotationFromTaitBryan(angles).isApprox(expected, 1e-14));
}

TEST(TaitBryan, RoundTripsOverTheWholeRange) {
  for (double roll = -3.1; roll < 3.15; roll += 0.31) {
    for (double pitch = -1.57; pitch < 1.571; pitch += 0.157) {
      for (double yaw = -3.1; yaw < 3.15; yaw += 0.31) {
        const TaitBryan back = TaitBryanFromRotation(RotationFromTaitBryan({roll, pitch, yaw}));
        ASSERT_NEAR(back.roll, roll, 1e-9);
        ASSERT_NEAR(back.pitch, pitch, 1e-9);
        ASSERT_NEAR(back.yaw, yaw, 1e-9);
      }
    }
  }
}

TEST(TaitBryan, SetsRollToZeroInGimbalLock) {
  for (const double pitch : {-kPi / 2.0, kPi / 2.0}) {
    const Matrix3d R = RotationFromTaitBryan({.roll = 0.4, .pitch = pitch, .yaw = 1.0});
    const TaitBryan angles = TaitBryanFromRotation(R);
    EXPECT_EQ(angles.roll, 0.0);
    EXPECT_NEAR(angles.pitch, pitch, 1e-8);
    EXPECT_TRUE(RotationFromTaitBryan(angles).isApprox(R, 1e-8));
  }
}

TEST(WrapToPi, StaysInItsHalfOpenInterval) {
  EXPECT_EQ(WrapToPi(0.0), 0.0);
  EXPECT_EQ(WrapToPi(kPi), kPi);
  EXPECT_EQ(WrapToPi(-kPi), kPi);
  for (double angle = -40.0; angle < 40.0; angle += 0.0173) {
    const double wrapped = WrapToPi(angle);
    ASSERT_GT(wrapped, -kPi);
    ASSERT_LE(wrapped, kPi);
    ASSERT_NEAR(std::sin(wrapped), std::sin(angle), 1e-12);
    ASSERT_NEAR(std::cos(wrapped), std::cos(angle), 1e-12);
  }
}

TEST(WrapToHalfPi, PreservesTheAngleModuloPi) {
  EXPECT_EQ(WrapToHalfPi(kPi / 2.0), kPi / 2.0);
  EXPECT_EQ(WrapToHalfPi(-kPi / 2.0), kPi / 2.0);
  for (double angle = -40.0; angle < 40.0; angle += 0.0173) {
    const double wrapped = WrapToHalfPi(angle);
    ASSERT_GT(wrapped, -kPi / 2.0);
    ASSERT_LE(wrapped, kPi / 2.0);
    ASSERT_NEAR(std::sin(2.0 * wrapped), std::sin(2.0 * angle), 1e-11);
    ASSERT_NEAR(std::cos(2.0 * wrapped), std::cos(2.0 * angle), 1e-11);
  }
}

TEST(ShortestRotation, RotatesOneVectorOntoTheOtherAboutTheirNormal) {
  RandomStream random(1, "test");
  for (int i = 0; i < 200; ++i) {
    const Vector3d from = UnitVector(random), to = UnitVector(random);
    const Matrix3d R = ShortestRotation(from, to);
    EXPECT_TRUE(IsRotation(R));
    EXPECT_TRUE((R * from).isApprox(to, 1e-9));
    EXPECT_TRUE((R * from.cross(to)).isApprox(from.cross(to), 1e-9));
  }
}

TEST(ShortestRotation, HandlesEqualAndOppositeVectors) {
  const Vector3d up = Vector3d::UnitZ();
  EXPECT_TRUE(ShortestRotation(up, up).isApprox(Matrix3d::Identity(), 1e-15));
  const Matrix3d opposite = ShortestRotation(up, -up);
  EXPECT_TRUE(IsRotation(opposite));
  EXPECT_TRUE((opposite * up).isApprox(-up, 1e-12));
  const Vector3d nearly = Vector3d(1e-9, 0.0, 1.0).normalized();
  EXPECT_NEAR((ShortestRotation(up, nearly) * up).x(), 1e-9, 1e-12);
}

TEST(RotationExp, RotatesAboutItsVectorByItsNorm) {
  EXPECT_EQ(RotationExp(Vector3d::Zero()), Matrix3d::Identity());
  EXPECT_TRUE(RotationExp({0.0, 0.0, 0.3}).isApprox(RotationFromTaitBryan({.yaw = 0.3}), 1e-15));
  EXPECT_NEAR(RotationExp({1e-12, 0.0, 0.0})(2, 1), 1e-12, 1e-20);
}

TEST(RotationLog, IsTheInverseOfRotationExp) {
  RandomStream random(2, "test");
  for (int i = 0; i < 500; ++i) {
    const Vector3d phi = random.Uniform(0.0, 3.1) * UnitVector(random);
    EXPECT_LT((RotationLog(RotationExp(phi)) - phi).norm(), 1e-9);
  }
  EXPECT_EQ(RotationLog(Matrix3d::Identity()), Vector3d::Zero());
  EXPECT_NEAR(RotationLog(RotationExp({0.0, kPi, 0.0})).norm(), kPi, 1e-7);
}

}  // namespace
}  // namespace touchdown::models
