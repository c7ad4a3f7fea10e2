#include "sim/dynamics/hand.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "models/angles.h"
#include "models/error.h"
#include "models/vehicle.h"

namespace touchdown::sim {
namespace {

using testing::DoubleNear;

class HandTest : public testing::TestWithParam<int> {
 protected:
  static Eigen::Isometry3d RestPose() {
    Eigen::Isometry3d X_WB(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitZ()));
    X_WB.translation() = Eigen::Vector3d(0.02, -0.01, 0.14);
    return X_WB;
  }

  models::TimeBase time_;
  HandConfig config_{.carries = true};
  Hand hand_{config_, RestPose(), time_, static_cast<std::uint64_t>(GetParam())};
  const models::Tick end_ = time_.FromSeconds(Hand::kTimeAtRest_s + config_.duration_s);
};

INSTANTIATE_TEST_SUITE_P(Seeds, HandTest, testing::Range(1, 7));

TEST_P(HandTest, KeepsTheVehicleOnTheGroundAtFirst) {
  EXPECT_TRUE(hand_.IsOnGround(time_.FromSeconds(1.9)));
  EXPECT_FALSE(hand_.IsOnGround(time_.FromSeconds(2.1)));
  EXPECT_TRUE(hand_.At(0).X_WB.isApprox(RestPose()));
  EXPECT_TRUE(hand_.At(time_.FromSeconds(1.9)).v_WB.isZero());
}

TEST_P(HandTest, ReachesButNeverExceedsItsMaximumHeightAndTilts) {
  double height = 0.0, roll = 0.0, pitch = 0.0;
  for (models::Tick tick = 0; tick < end_; tick += 20) {
    const BodyMotion motion = hand_.At(tick);
    const models::TaitBryan angles = models::TaitBryanFromRotation(motion.X_WB.linear());
    height = std::max(height, motion.X_WB.translation().z());
    roll = std::max(roll, std::abs(angles.roll));
    pitch = std::max(pitch, std::abs(angles.pitch));
  }
  EXPECT_THAT(height, DoubleNear(config_.max_height_m, 0.01));
  EXPECT_THAT(roll, DoubleNear(models::DegToRad(config_.max_tilt_deg), 0.01));
  EXPECT_THAT(pitch, DoubleNear(models::DegToRad(config_.max_tilt_deg), 0.01));
}

TEST_P(HandTest, StaysAboveThePad) {
  double farthest = 0.0;
  for (models::Tick tick = time_.FromSeconds(Hand::kTimeAtRest_s + 2.5); tick < end_; tick += 20) {
    const Eigen::Vector3d p_WB = hand_.At(tick).X_WB.translation();
    farthest = std::max(farthest, p_WB.head<2>().cwiseAbs().maxCoeff() / p_WB.z());
  }
  EXPECT_THAT(farthest, DoubleNear(0.25, 0.01));
}

TEST_P(HandTest, MovesSmoothlyAndConsistentlyWithItsVelocities) {
  const double dt_s = time_.period_s();
  BodyMotion before = hand_.At(0);
  for (models::Tick tick = 1; tick < end_; ++tick) {
    const BodyMotion now = hand_.At(tick);
    const Eigen::Vector3d v_W = (now.X_WB.translation() - before.X_WB.translation()) / dt_s;
    const Eigen::Vector3d w_B = models::RotationLog(before.X_WB.linear().transpose() * now.X_WB.linear()) / dt_s;
    ASSERT_LT((v_W - 0.5 * (now.v_WB + before.v_WB)).norm(), 1e-4) << tick;
    ASSERT_LT((w_B - 0.5 * (now.w_WB_B + before.w_WB_B)).norm(), 1e-3) << tick;
    ASSERT_LT((now.v_WB - before.v_WB).norm() / dt_s, 5.0)
        << tick;  // m/s^2, the acceleration of a hand, not of an impact.
    before = now;
  }
}

TEST_P(HandTest, DiffersForAnotherSeed) {
  const Hand same(config_, RestPose(), time_, static_cast<std::uint64_t>(GetParam()));
  const Hand other(config_, RestPose(), time_, 100);
  const models::Tick tick = time_.FromSeconds(20.0);
  EXPECT_EQ(hand_.At(tick).X_WB.matrix(), same.At(tick).X_WB.matrix());
  EXPECT_GT((hand_.At(tick).X_WB.translation() - other.At(tick).X_WB.translation()).norm(), 0.01);
}

TEST(HandConfigTest, RejectsMotionsThatNoHandCanMake) {
  EXPECT_NO_THROW(HandConfig{}.Validate());
  EXPECT_THROW(HandConfig{.duration_s = 1.0}.Validate(), InputError);
  EXPECT_THROW(HandConfig{.max_height_m = 10.0}.Validate(), InputError);
  EXPECT_THROW(HandConfig{.max_tilt_deg = std::nan("")}.Validate(), InputError);
  EXPECT_THROW(HandConfig{.tremor_hz = 0.0}.Validate(), InputError);
}

}  // namespace
}  // namespace touchdown::sim
