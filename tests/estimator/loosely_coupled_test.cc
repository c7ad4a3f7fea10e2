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

/// Result that ScriptedVision returns, and the arguments that it received.
struct Script {
  FrameStatus status = FrameStatus::kOk;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  Eigen::Matrix<double, 6, 6> covariance = 1e-4 * Eigen::Matrix<double, 6, 6>::Identity();
  std::optional<Vector3d> gravity_B;
  int resets = 0;
};

class ScriptedVision final : public VisionEstimator {
 public:
  explicit ScriptedVision(Script* script) : script_(script) {}

  FrameResult Estimate(const models::ImageView&, Tick mid_exposure, const std::optional<Vector3d>& gravity_B) override {
    script_->gravity_B = gravity_B;
    FrameResult estimate;
    estimate.mid_exposure = mid_exposure;
    estimate.status = script_->status;
    if (script_->status == FrameStatus::kOk || script_->status == FrameStatus::kRejected) {
      estimate.pose = VisionPose{.X_WB = script_->X_WB, .covariance = script_->covariance};
    }
    return estimate;
  }
  void Reset() override { ++script_->resets; }

 private:
  Script* script_;
};

class LooselyCoupledTest : public testing::Test {
 protected:
  /// Adds IMU samples of a body at rest in the attitude R_WB, at ticks [from, to).
  void AddRest(Tick from, Tick to, const Eigen::Matrix3d& R_WB = Eigen::Matrix3d::Identity()) {
    for (Tick tick = from; tick < to; tick += kImuPeriod) {
      const Vector3d up_B = R_WB.row(2);
      estimator_.AddImu({.tick = tick, .specific_force_U = models::kGravity_m_s2 * up_B}, false);
    }
  }
  FrameResult AddFrame(Tick mid_exposure) { return estimator_.AddFrame({}, mid_exposure); }

  Script vision_;
  LooselyCoupled estimator_{
      std::make_unique<ScriptedVision>(&vision_), {}, models::TimeBase(), Eigen::Matrix3d::Identity()};
};

TEST_F(LooselyCoupledTest, EstimatesAttitudeButNotPositionBeforeAnyFrame) {
  const TaitBryan truth{.roll = 0.2, .pitch = -0.1};
  AddRest(0, 240, models::RotationFromTaitBryan(truth));
  const models::VehicleEstimate estimate = estimator_.StateAt(240).value();
  EXPECT_EQ(estimate.tick, 240);
  EXPECT_NEAR(estimate.attitude.roll, truth.roll, 1e-6);
  EXPECT_NEAR(estimate.attitude.pitch, truth.pitch, 1e-6);
  EXPECT_FALSE(estimate.motion);
  EXPECT_FALSE(estimate.pad_seen);
}

TEST_F(LooselyCoupledTest, UsesPositionAndYawOfAFrame) {
  AddRest(0, 60);
  vision_.X_WB = PoseAt({0.1, -0.2, 1.0}, {.yaw = 0.3});
  const FrameResult result = AddFrame(40);
  EXPECT_EQ(result.status, FrameStatus::kOk);
  EXPECT_EQ(result.mid_exposure, 40);
  const models::VehicleEstimate estimate = estimator_.StateAt(60).value();
  EXPECT_EQ(estimate.pad_seen, 40);
  ASSERT_TRUE(estimate.motion);
  EXPECT_TRUE(estimate.motion->p_WB.isApprox(Vector3d(0.1, -0.2, 1.0)));
  EXPECT_NEAR(estimate.attitude.yaw, 0.3, 1e-9);
}

TEST_F(LooselyCoupledTest, PassesGravityAtMidExposureToVision) {
  const Eigen::Matrix3d R_BU = Eigen::Matrix3d::Identity();
  LooselyCoupled estimator(std::make_unique<ScriptedVision>(&vision_), {}, models::TimeBase(), R_BU);
  const double rate = 1.0;  // rad/s about X, from level at tick 0.
  for (Tick tick = 0; tick <= 120; tick += kImuPeriod) {
    const double roll = rate * models::TimeBase().ToSeconds(tick);
    const Vector3d up_B(0.0, std::sin(roll), std::cos(roll));
    estimator.AddImu({.tick = tick, .specific_force_U = models::kGravity_m_s2 * up_B, .w_WU_U = {rate, 0.0, 0.0}},
                     false);
  }
  estimator.AddFrame({}, 60);
  const double then = rate * models::TimeBase().ToSeconds(60);
  EXPECT_NEAR(std::atan2(-vision_.gravity_B->y(), -vision_.gravity_B->z()), then, DegToRad(0.1));
}

TEST_F(LooselyCoupledTest, PredictsFromTheMidExposureOfALateFrame) {
  Tick tick = 0;
  for (int i = 0; i < 120; ++i, tick += kFramePeriod) {
    AddRest(tick, tick + kFramePeriod - 2);
    vision_.X_WB = PoseAt({0.5 * models::TimeBase().ToSeconds(tick), 0.0, 1.0});
    AddFrame(tick);
  }
  const Tick newest = tick - kFramePeriod, now = newest + 60;
  const models::VehicleEstimate estimate = estimator_.StateAt(now).value();
  EXPECT_EQ(estimate.pad_seen, newest);
  EXPECT_NEAR(estimate.motion->p_WB.x(), 0.5 * models::TimeBase().ToSeconds(now), 0.005);
}

TEST_F(LooselyCoupledTest, IgnoresAFrameOlderThanTheNewestUsed) {
  AddRest(0, 120);
  vision_.X_WB = PoseAt({0.0, 0.0, 1.0});
  AddFrame(60);
  vision_.X_WB = PoseAt({0.5, 0.0, 1.0}, {.yaw = 0.5});
  AddFrame(40);
  const models::VehicleEstimate estimate = estimator_.StateAt(120).value();
  EXPECT_EQ(estimate.pad_seen, 60);
  EXPECT_EQ(estimate.motion->p_WB.x(), 0.0);
  EXPECT_NEAR(estimate.attitude.yaw, 0.0, 1e-9);
}

TEST_F(LooselyCoupledTest, ResolvesTheYawAmbiguityBeyond90Degrees) {
  Tick tick = 0;
  // The body rotates left by 120 degrees at 1 rad/s. At 90 degrees vision's yaw jumps to -90 degrees and its position
  // changes accordingly.
  const Vector3d p_WB(0.3, -0.2, 1.0);
  double yaw = 0.0;
  for (; yaw < DegToRad(120.0); tick += kImuPeriod) {
    yaw = models::TimeBase().ToSeconds(tick);
    estimator_.AddImu({.tick = tick, .specific_force_U = {0.0, 0.0, models::kGravity_m_s2}, .w_WU_U = {0.0, 0.0, 1.0}},
                      false);
    const bool beyond = yaw > DegToRad(90.0);
    vision_.X_WB = PoseAt(beyond ? Vector3d(-0.3, 0.2, 1.0) : p_WB, {.yaw = models::WrapToHalfPi(yaw)});
    AddFrame(tick);
  }
  const models::VehicleEstimate estimate = estimator_.StateAt(tick - kImuPeriod).value();
  EXPECT_NEAR(estimate.attitude.yaw, yaw, DegToRad(1.0));
  EXPECT_LT((estimate.motion->p_WB - p_WB).norm(), 0.01);
}

TEST_F(LooselyCoupledTest, IgnoresFramesWhoseStatusIsNotOk) {
  AddRest(0, 60);
  vision_.X_WB = PoseAt({0.0, 0.0, 1.0});
  AddFrame(20);
  vision_.X_WB = PoseAt({5.0, 0.0, 1.0}, {.yaw = 1.0});
  for (const FrameStatus status : {FrameStatus::kRejected, FrameStatus::kNotFound}) {
    vision_.status = status;
    EXPECT_EQ(AddFrame(40).status, status);
  }
  const models::VehicleEstimate estimate = estimator_.StateAt(60).value();
  EXPECT_EQ(estimate.pad_seen, 20);
  EXPECT_EQ(estimate.motion->p_WB.x(), 0.0);
  EXPECT_NEAR(estimate.attitude.yaw, 0.0, 1e-9);
}

TEST_F(LooselyCoupledTest, EstimatesTheImuBiasAtRest) {
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
  AddFrame(0);
  EXPECT_FALSE(vision_.gravity_B);
  AddRest(6, 12);
  AddFrame(12);
  EXPECT_TRUE(vision_.gravity_B);
  EXPECT_TRUE(estimator_.StateAt(12));
}

TEST_F(LooselyCoupledTest, TracksThePadWhileTheNewestFrameIsOk) {
  AddRest(0, 60);
  EXPECT_FALSE(estimator_.StateAt(60)->pad_tracked);
  AddFrame(20);
  EXPECT_TRUE(estimator_.StateAt(60)->pad_tracked);
  vision_.status = FrameStatus::kNotFound;
  AddFrame(40);
  EXPECT_FALSE(estimator_.StateAt(60)->pad_tracked);
  EXPECT_EQ(estimator_.StateAt(60)->pad_seen, 20);
}

TEST_F(LooselyCoupledTest, ReportsAPositiveDefiniteCovarianceThatGrowsWithoutFrames) {
  AddRest(0, 60);
  EXPECT_FALSE(estimator_.StateAt(60)->covariance);
  AddFrame(40);
  const auto soon = estimator_.StateAt(60)->covariance.value(), late = estimator_.StateAt(600)->covariance.value();
  for (const auto& covariance : {soon, late}) {
    EXPECT_EQ(covariance, covariance.transpose());
    EXPECT_EQ(covariance.llt().info(), Eigen::Success);
  }
  EXPECT_GT(late(0, 0), soon(0, 0));
  EXPECT_GT(late(8, 8), soon(8, 8));
}

TEST_F(LooselyCoupledTest, ReportsTheSpecificForceMinusTheCommandedThrust) {
  const Vector3d wind(0.3, -0.2, 0.1), thrust(0.0, 0.0, models::kGravity_m_s2);
  EXPECT_FALSE(estimator_.StateAt(0));
  estimator_.AddImu({.tick = 0, .specific_force_U = thrust}, false);
  EXPECT_FALSE(estimator_.StateAt(0)->disturbance_B_m_s2);
  estimator_.AddCommand(0, thrust.z());
  estimator_.AddImu({.tick = 6, .specific_force_U = thrust + wind}, false);
  EXPECT_TRUE(estimator_.StateAt(6)->disturbance_B_m_s2->isApprox(wind));
}

TEST_F(LooselyCoupledTest, RestoresTheInitialStateOnReset) {
  AddRest(0, 60, models::RotationFromTaitBryan({.roll = 0.3}));
  AddFrame(40);
  estimator_.AddCommand(54, 9.0);
  estimator_.Reset();
  EXPECT_EQ(vision_.resets, 1);
  EXPECT_FALSE(estimator_.StateAt(60));
  AddRest(0, 6);
  const models::VehicleEstimate estimate = estimator_.StateAt(0).value();
  EXPECT_NEAR(estimate.attitude.roll, 0.0, 1e-9);
  EXPECT_FALSE(estimate.motion || estimate.pad_seen || estimate.pad_tracked || estimate.disturbance_B_m_s2);
}

}  // namespace
}  // namespace touchdown::estimator
