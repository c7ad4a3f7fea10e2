#include "estimator/loosely_coupled.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace touchdown::estimator {
namespace {

using Eigen::Vector3d;
using models::DegToRad;
using models::TaitBryan;
using models::Tick;

constexpr Tick kImuPeriod = 6, kFramePeriod = 20;

Eigen::Isometry3d PoseAt(const Vector3d& p_WB, const TaitBryan& attitude = {}) {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.linear() = models::RotationFromTaitBryan(attitude);
  X_WB.translation() = p_WB;
  return X_WB;
}

/// Vision that says what the test wants, and remembers what it was told.
struct Saying {
  FrameStatus status = FrameStatus::kOk;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  Eigen::Matrix<double, 6, 6> covariance = 1e-4 * Eigen::Matrix<double, 6, 6>::Identity();
  std::optional<Vector3d> gravity_B;
  int resets = 0;
};

class ScriptedVision final : public VisionEstimator {
 public:
  explicit ScriptedVision(Saying* saying) : saying_(saying) {}

  FrameResult Estimate(const models::ImageView&, Tick mid_exposure, const std::optional<Vector3d>& gravity_B) override {
    saying_->gravity_B = gravity_B;
    FrameResult estimate;
    estimate.mid_exposure = mid_exposure;
    estimate.status = saying_->status;
    if (saying_->status == FrameStatus::kOk || saying_->status == FrameStatus::kRejected) {
      estimate.pose = VisionPose{.X_WB = saying_->X_WB, .covariance = saying_->covariance};
    }
    return estimate;
  }
  void Reset() override { ++saying_->resets; }

 private:
  Saying* saying_;
};

class LooselyCoupledTest : public testing::Test {
 protected:
  /// Feeds the IMU, at rest in the attitude R_WB, over [from, to).
  void Rest(Tick from, Tick to, const Eigen::Matrix3d& R_WB = Eigen::Matrix3d::Identity()) {
    for (Tick tick = from; tick < to; tick += kImuPeriod) {
      const Vector3d up_B = R_WB.row(2);
      estimator_.AddImu({.tick = tick, .specific_force_U = models::kGravity_m_s2 * up_B}, false);
    }
  }
  FrameResult See(Tick mid_exposure) { return estimator_.AddFrame({}, mid_exposure); }

  Saying vision_;
  LooselyCoupled estimator_{
      std::make_unique<ScriptedVision>(&vision_), {}, models::TimeBase(), Eigen::Matrix3d::Identity()};
};

TEST_F(LooselyCoupledTest, KnowsItsAttitudeButNotItsPlaceBeforeAnyFrame) {
  const TaitBryan truth{.roll = 0.2, .pitch = -0.1};
  Rest(0, 240, models::RotationFromTaitBryan(truth));
  const models::VehicleEstimate estimate = estimator_.StateAt(240).value();
  EXPECT_EQ(estimate.tick, 240);
  EXPECT_NEAR(estimate.attitude.roll, truth.roll, 1e-6);
  EXPECT_NEAR(estimate.attitude.pitch, truth.pitch, 1e-6);
  EXPECT_FALSE(estimate.motion);
  EXPECT_FALSE(estimate.pad_seen);
}

TEST_F(LooselyCoupledTest, TakesPlaceAndYawFromAFrame) {
  Rest(0, 60);
  vision_.X_WB = PoseAt({0.1, -0.2, 1.0}, {.yaw = 0.3});
  const FrameResult seen = See(40);
  EXPECT_EQ(seen.status, FrameStatus::kOk);
  EXPECT_EQ(seen.mid_exposure, 40);
  const models::VehicleEstimate estimate = estimator_.StateAt(60).value();
  EXPECT_EQ(estimate.pad_seen, 40);
  ASSERT_TRUE(estimate.motion);
  EXPECT_TRUE(estimate.motion->p_WB.isApprox(Vector3d(0.1, -0.2, 1.0)));
  EXPECT_NEAR(estimate.attitude.yaw, 0.3, 1e-9);
}

TEST_F(LooselyCoupledTest, JudgesALateFrameByGravityAtItsExposure) {
  const Eigen::Matrix3d R_BU = Eigen::Matrix3d::Identity();
  LooselyCoupled turning(std::make_unique<ScriptedVision>(&vision_), {}, models::TimeBase(), R_BU);
  const double rate = 1.0;  // About X, from level at tick 0.
  for (Tick tick = 0; tick <= 120; tick += kImuPeriod) {
    const double roll = rate * models::TimeBase().ToSeconds(tick);
    const Vector3d up_B(0.0, std::sin(roll), std::cos(roll));
    turning.AddImu({.tick = tick, .specific_force_U = models::kGravity_m_s2 * up_B, .w_WU_U = {rate, 0.0, 0.0}}, false);
  }
  turning.AddFrame({}, 60);
  const double then = rate * models::TimeBase().ToSeconds(60);
  EXPECT_NEAR(std::atan2(-vision_.gravity_B->y(), -vision_.gravity_B->z()), then, DegToRad(0.1));
}

TEST_F(LooselyCoupledTest, PredictsFromTheExposureOfALateFrame) {
  Tick tick = 0;
  for (int i = 0; i < 120; ++i, tick += kFramePeriod) {
    Rest(tick, tick + kFramePeriod - 2);
    vision_.X_WB = PoseAt({0.5 * models::TimeBase().ToSeconds(tick), 0.0, 1.0});
    See(tick);
  }
  const Tick newest = tick - kFramePeriod, now = newest + 60;
  const models::VehicleEstimate estimate = estimator_.StateAt(now).value();
  EXPECT_EQ(estimate.pad_seen, newest);
  EXPECT_NEAR(estimate.motion->p_WB.x(), 0.5 * models::TimeBase().ToSeconds(now), 0.005);
}

TEST_F(LooselyCoupledTest, IgnoresAFrameOlderThanTheNewestUsed) {
  Rest(0, 120);
  vision_.X_WB = PoseAt({0.0, 0.0, 1.0});
  See(60);
  vision_.X_WB = PoseAt({0.5, 0.0, 1.0}, {.yaw = 0.5});
  See(40);
  const models::VehicleEstimate estimate = estimator_.StateAt(120).value();
  EXPECT_EQ(estimate.pad_seen, 60);
  EXPECT_EQ(estimate.motion->p_WB.x(), 0.0);
  EXPECT_NEAR(estimate.attitude.yaw, 0.0, 1e-9);
}

TEST_F(LooselyCoupledTest, TakesTheTwinWhenTheYawIsBeyondWhatVisionCanTell) {
  Tick tick = 0;
  // Turns left through 120 degrees at 1 rad/s; vision's yaw jumps from 90 to -90 degrees on the way, and with it the
  // place that it tells.
  const Vector3d p_WB(0.3, -0.2, 1.0);
  double yaw = 0.0;
  for (; yaw < DegToRad(120.0); tick += kImuPeriod) {
    yaw = models::TimeBase().ToSeconds(tick);
    estimator_.AddImu({.tick = tick, .specific_force_U = {0.0, 0.0, models::kGravity_m_s2}, .w_WU_U = {0.0, 0.0, 1.0}},
                      false);
    const bool beyond = yaw > DegToRad(90.0);
    vision_.X_WB = PoseAt(beyond ? Vector3d(-0.3, 0.2, 1.0) : p_WB, {.yaw = models::WrapToHalfPi(yaw)});
    See(tick);
  }
  const models::VehicleEstimate estimate = estimator_.StateAt(tick - kImuPeriod).value();
  EXPECT_NEAR(estimate.attitude.yaw, yaw, DegToRad(1.0));
  EXPECT_LT((estimate.motion->p_WB - p_WB).norm(), 0.01);
}

TEST_F(LooselyCoupledTest, LeavesOutFramesThatAreNotOk) {
  Rest(0, 60);
  vision_.X_WB = PoseAt({0.0, 0.0, 1.0});
  See(20);
  vision_.X_WB = PoseAt({5.0, 0.0, 1.0}, {.yaw = 1.0});
  for (const FrameStatus status : {FrameStatus::kRejected, FrameStatus::kNotFound}) {
    vision_.status = status;
    EXPECT_EQ(See(40).status, status);
  }
  const models::VehicleEstimate estimate = estimator_.StateAt(60).value();
  EXPECT_EQ(estimate.pad_seen, 20);
  EXPECT_EQ(estimate.motion->p_WB.x(), 0.0);
  EXPECT_NEAR(estimate.attitude.yaw, 0.0, 1e-9);
}

TEST_F(LooselyCoupledTest, LearnsTheBiasOfTheImuAtRest) {
  const Vector3d bias(0.2, -0.3, 0.0);
  for (Tick tick = -1200; tick < 0; tick += kImuPeriod) {
    estimator_.AddImu({.tick = tick, .specific_force_U = Vector3d(0.0, 0.0, models::kGravity_m_s2) + bias}, true);
  }
  estimator_.AddImu({.tick = 0, .specific_force_U = Vector3d(0.0, 0.0, models::kGravity_m_s2) + bias}, false);
  const TaitBryan attitude = estimator_.StateAt(0).value().attitude;
  EXPECT_LT(std::hypot(attitude.roll, attitude.pitch), DegToRad(0.1));
}

TEST_F(LooselyCoupledTest, HasNoStateAndNoGravityBeforeTheFirstImuSample) {
  EXPECT_FALSE(estimator_.StateAt(0));
  See(0);
  EXPECT_FALSE(vision_.gravity_B);
  Rest(6, 12);
  See(12);
  EXPECT_TRUE(vision_.gravity_B);
  EXPECT_TRUE(estimator_.StateAt(12));
}

TEST_F(LooselyCoupledTest, TracksThePadWhileTheNewestFrameShowsIt) {
  Rest(0, 60);
  EXPECT_FALSE(estimator_.StateAt(60)->pad_tracked);
  See(20);
  EXPECT_TRUE(estimator_.StateAt(60)->pad_tracked);
  vision_.status = FrameStatus::kNotFound;
  See(40);
  EXPECT_FALSE(estimator_.StateAt(60)->pad_tracked);
  EXPECT_EQ(estimator_.StateAt(60)->pad_seen, 20);
}

TEST_F(LooselyCoupledTest, ClaimsACovarianceThatIsPositiveDefiniteAndGrowsUntilTheNextFrame) {
  Rest(0, 60);
  EXPECT_FALSE(estimator_.StateAt(60)->covariance);
  See(40);
  const auto soon = estimator_.StateAt(60)->covariance.value(), late = estimator_.StateAt(600)->covariance.value();
  for (const auto& covariance : {soon, late}) {
    EXPECT_EQ(covariance, covariance.transpose());
    EXPECT_EQ(covariance.llt().info(), Eigen::Success);
  }
  EXPECT_GT(late(0, 0), soon(0, 0));
  EXPECT_GT(late(8, 8), soon(8, 8));
}

TEST_F(LooselyCoupledTest, ReportsTheForceThatTheCommandedThrustDoesNotExplain) {
  const Vector3d wind(0.3, -0.2, 0.1), thrust(0.0, 0.0, models::kGravity_m_s2);
  EXPECT_FALSE(estimator_.StateAt(0));
  estimator_.AddImu({.tick = 0, .specific_force_U = thrust}, false);
  EXPECT_FALSE(estimator_.StateAt(0)->disturbance_B_m_s2);
  estimator_.AddCommand(0, thrust.z());
  estimator_.AddImu({.tick = 6, .specific_force_U = thrust + wind}, false);
  EXPECT_TRUE(estimator_.StateAt(6)->disturbance_B_m_s2->isApprox(wind));
}

TEST_F(LooselyCoupledTest, ForgetsEverythingOnReset) {
  Rest(0, 60, models::RotationFromTaitBryan({.roll = 0.3}));
  See(40);
  estimator_.AddCommand(54, 9.0);
  estimator_.Reset();
  EXPECT_EQ(vision_.resets, 1);
  EXPECT_FALSE(estimator_.StateAt(60));
  Rest(0, 6);
  const models::VehicleEstimate estimate = estimator_.StateAt(0).value();
  EXPECT_NEAR(estimate.attitude.roll, 0.0, 1e-9);
  EXPECT_FALSE(estimate.motion || estimate.pad_seen || estimate.pad_tracked || estimate.disturbance_B_m_s2);
}

}  // namespace
}  // namespace touchdown::estimator
