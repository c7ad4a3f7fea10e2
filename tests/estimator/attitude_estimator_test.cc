#include "estimator/attitude_estimator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/error.h"
#include "models/random_stream.h"
#include "tests/support/nominal.h"

namespace touchdown::estimator {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using models::DegToRad;
using models::TaitBryan;
using models::Tick;
using tests::kPeriod_s;
using tests::kTime;

constexpr Tick kPeriod = 6;

/// Simulated body with an IMU; the test sets its motion.
class Body {
 public:
  explicit Body(const TaitBryan& start = {}) : R_WB(models::RotationFromTaitBryan(start)) {}

  Matrix3d R_WB;
  Vector3d gyro_bias = Vector3d::Zero(), accelerometer_bias = Vector3d::Zero();
  Vector3d a_WB = Vector3d::Zero();  ///< Acceleration of the body's origin, m/s^2.
  double gyro_noise = 0.0, accelerometer_noise = 0.0;
  Tick tick = 0;

  /// Rotates the body at `w_WB_B` for one IMU period and returns the sample of an IMU mounted with R_BU.
  models::ImuSample Step(const Vector3d& w_WB_B = Vector3d::Zero(), const Matrix3d& R_BU = Matrix3d::Identity()) {
    R_WB = R_WB * models::RotationExp(w_WB_B * kPeriod_s);
    tick += kPeriod;
    const Vector3d f_B = R_WB.transpose() * (a_WB + Vector3d(0.0, 0.0, models::kGravity_m_s2));
    return {.tick = tick,
            .specific_force_U =
                R_BU.transpose() * (f_B + accelerometer_bias) + accelerometer_noise * random_.NormalVector3(),
            .w_WU_U = R_BU.transpose() * (w_WB_B + gyro_bias) + gyro_noise * random_.NormalVector3()};
  }
  TaitBryan attitude() const { return models::TaitBryanFromRotation(R_WB); }
  Vector3d gravity_B() const { return -R_WB.transpose().col(2); }

 private:
  models::RandomStream random_{3, "attitude_estimator_test"};
};

AttitudeEstimator DefaultAttitudeEstimator(const Matrix3d& R_BU = Matrix3d::Identity()) {
  return {AttitudeEstimatorConfig{}, kTime, R_BU};
}

void Feed(AttitudeEstimator& estimator, Body& body, double duration_s, bool at_rest,
          const Vector3d& w_WB_B = Vector3d::Zero()) {
  for (int i = 0; i * kPeriod_s < duration_s; ++i) estimator.Update(body.Step(w_WB_B), at_rest);
}

double TiltError(const AttitudeEstimator& estimator, const Body& body) {
  return std::acos(std::min(1.0, estimator.GravityAt(body.tick).dot(body.gravity_B())));
}

TEST(AttitudeEstimator, StartsWithTheFirstSampleAboveTheMinimumSpecificForce) {
  const TaitBryan truth{.roll = 0.3, .pitch = -0.2};
  Body body(truth);
  body.a_WB.z() = -0.95 * models::kGravity_m_s2;
  AttitudeEstimator estimator = DefaultAttitudeEstimator();
  estimator.Update(body.Step(), false);
  EXPECT_EQ(estimator.GravityAt(body.tick), Vector3d(0.0, 0.0, -1.0));
  body.a_WB.setZero();
  estimator.Update(body.Step(), false);
  EXPECT_NEAR(estimator.attitude().roll, truth.roll, 1e-9);
  EXPECT_NEAR(estimator.attitude().pitch, truth.pitch, 1e-9);
}

TEST(AttitudeEstimator, ReportsTheBodyRateBeforeTheAttitudeIsInitialized) {
  AttitudeEstimator estimator = DefaultAttitudeEstimator();
  estimator.Update({.tick = 6, .specific_force_U = Vector3d::Zero(), .w_WU_U = {0.1, 0.2, 0.3}}, false);
  EXPECT_EQ(estimator.w_WB_B(), Vector3d(0.1, 0.2, 0.3));
}

TEST(AttitudeEstimator, InitializesTheTiltFromTheFirstSample) {
  const TaitBryan truth{.roll = 0.3, .pitch = -0.2};
  Body body(truth);
  AttitudeEstimator estimator = DefaultAttitudeEstimator();
  estimator.Update(body.Step(), false);
  EXPECT_NEAR(estimator.attitude().roll, truth.roll, 1e-9);
  EXPECT_NEAR(estimator.attitude().pitch, truth.pitch, 1e-9);
  EXPECT_NEAR(estimator.attitude().yaw, 0.0, 1e-9);
}

TEST(AttitudeEstimator, AppliesTheMountingOfTheImu) {
  const Matrix3d R_BU = models::RotationFromTaitBryan({.roll = 0.05, .pitch = -0.04, .yaw = 0.7});
  Body body({.roll = 0.2, .pitch = 0.1});
  AttitudeEstimator estimator = DefaultAttitudeEstimator(R_BU);
  const Vector3d w_WB_B(0.3, -0.4, 0.5);
  for (int i = 0; i < 200; ++i) estimator.Update(body.Step(w_WB_B, R_BU), false);
  EXPECT_LT(TiltError(estimator, body), DegToRad(0.1));
  EXPECT_NEAR((estimator.w_WB_B() - w_WB_B).norm(), 0.0, 2e-3);
}

TEST(AttitudeEstimator, FollowsFastRotationsWithTheGyro) {
  Body body;
  AttitudeEstimator estimator = DefaultAttitudeEstimator();
  Feed(estimator, body, 1.0, true);
  double yaw = 0.0;
  for (int i = 0; i < 400; ++i) {
    const double t = i * kPeriod_s;
    const Vector3d w(2.0 * std::cos(6.0 * t), 1.5 * std::sin(5.0 * t), 0.8);
    estimator.Update(body.Step(w), false);
    yaw = body.attitude().yaw;
  }
  EXPECT_LT(TiltError(estimator, body), DegToRad(0.5));
  EXPECT_NEAR(models::WrapToPi(estimator.attitude().yaw - yaw), 0.0, DegToRad(0.5));
}

TEST(AttitudeEstimator, EstimatesTheGyroBiasWithinASecondAtRest) {
  Body body;
  body.gyro_bias = {0.0087, -0.0087, 0.005};
  body.gyro_noise = 0.0123;  // Upper end of the sensor class: 8.7e-4 rad/s/sqrt(Hz).
  body.accelerometer_noise = 0.09;
  AttitudeEstimator estimator = DefaultAttitudeEstimator();
  Feed(estimator, body, 1.0, true);
  EXPECT_NEAR((estimator.gyro_bias_B() - body.gyro_bias).norm(), 0.0, DegToRad(0.15));
  EXPECT_LT(TiltError(estimator, body), DegToRad(0.25));
}

TEST(AttitudeEstimator, EstimatesTheGyroBiasInFlightWithin20Seconds) {
  Body body;
  body.gyro_bias = {0.0087, -0.0087, 0.0};
  body.gyro_noise = 0.0024;
  body.accelerometer_noise = 0.3;
  AttitudeEstimator estimator = DefaultAttitudeEstimator();
  double worst = 0.0;
  for (int i = 0; i < 4000; ++i) {
    estimator.Update(body.Step(), false);
    worst = std::max(worst, TiltError(estimator, body));
  }
  EXPECT_LT(worst, DegToRad(2.5));
  EXPECT_NEAR((estimator.gyro_bias_B() - body.gyro_bias).head<2>().norm(), 0.0, DegToRad(0.15));
  EXPECT_LT(TiltError(estimator, body), DegToRad(0.6));
}

TEST(AttitudeEstimator, LimitsTheTiltErrorDuringAManeuver) {
  Body body;
  AttitudeEstimator estimator = DefaultAttitudeEstimator();
  Feed(estimator, body, 1.0, true);
  // A quadrotor that tilts by 10 degrees to accelerate: the accelerometer measures thrust along body Z only.
  const double tilt = DegToRad(10.0);
  for (const double direction : {1.0, -1.0}) {
    Feed(estimator, body, 0.2, false, {0.0, direction * tilt / 0.2, 0.0});
    body.a_WB.x() = direction * models::kGravity_m_s2 * std::tan(tilt);
    Feed(estimator, body, 0.5, false);
    Feed(estimator, body, 0.2, false, {0.0, -direction * tilt / 0.2, 0.0});
    body.a_WB.setZero();
  }
  EXPECT_LT(TiltError(estimator, body), DegToRad(1.0));
}

TEST(AttitudeEstimator, IgnoresSpecificForceThatDeviatesFromGravity) {
  Body body;
  AttitudeEstimator estimator = DefaultAttitudeEstimator();
  Feed(estimator, body, 1.0, true);
  body.a_WB = {8.0, 0.0, 0.0};  // |f| is 1.29 g.
  Feed(estimator, body, 0.5, false);
  EXPECT_LT(TiltError(estimator, body), DegToRad(0.02));
}

TEST(AttitudeEstimator, EstimatesTheAccelerometerBiasOnLevelGround) {
  Body body;
  body.accelerometer_bias = {0.196, -0.3, 0.2};
  body.accelerometer_noise = 0.09;
  AttitudeEstimator estimator = DefaultAttitudeEstimator();
  Feed(estimator, body, 1.0, true);
  EXPECT_LT(TiltError(estimator, body), DegToRad(0.1));
  Feed(estimator, body, 0.2, false, {0.5, 0.3, 0.2});
  Feed(estimator, body, 30.0, false);
  EXPECT_LT(TiltError(estimator, body), DegToRad(0.2));
}

TEST(AttitudeEstimator, DoesNotAttributeASlopeToTheAccelerometerBias) {
  Body body({.roll = DegToRad(6.0), .pitch = DegToRad(-3.0)});
  body.accelerometer_noise = 0.09;
  AttitudeEstimator estimator = DefaultAttitudeEstimator();
  Feed(estimator, body, 1.0, true);
  EXPECT_LT(TiltError(estimator, body), DegToRad(0.3));
}

TEST(AttitudeEstimator, NeverAssumesLevelGroundWithToleranceZero) {
  AttitudeEstimatorConfig config;
  config.level_ground_tolerance_deg = 0.0;
  AttitudeEstimator estimator(config, kTime, Matrix3d::Identity());
  Body body({.roll = DegToRad(2.0)});
  Feed(estimator, body, 1.0, true);
  EXPECT_NEAR(estimator.attitude().roll, DegToRad(2.0), DegToRad(0.05));
}

TEST(AttitudeEstimator, HasATiltErrorFromTheAccelerometerBiasInFlight) {
  Body body;
  body.accelerometer_bias = {0.196, 0.0, 0.0};
  AttitudeEstimator estimator = DefaultAttitudeEstimator();
  Feed(estimator, body, 30.0, false);
  EXPECT_NEAR(TiltError(estimator, body), std::atan(0.196 / models::kGravity_m_s2), DegToRad(0.05));
}

TEST(AttitudeEstimator, SetsYawFromTheFirstFrameAndThenFollowsSlowly) {
  Body body({.yaw = 0.5});
  AttitudeEstimator estimator = DefaultAttitudeEstimator();
  Feed(estimator, body, 0.2, false);
  estimator.CorrectYaw(body.tick - 24, 0.5);
  EXPECT_NEAR(estimator.attitude().yaw, 0.5, 1e-3);
  estimator.Update(body.Step(), false);
  estimator.CorrectYaw(body.tick - 10, 0.7);
  EXPECT_NEAR(estimator.attitude().yaw, 0.5, 0.02);
  for (int i = 0; i < 600; ++i) {
    estimator.Update(body.Step(), false);
    if (i % 3 == 0) estimator.CorrectYaw(body.tick, 0.7);
  }
  EXPECT_NEAR(estimator.attitude().yaw, 0.7, 0.01);
}

TEST(AttitudeEstimator, ComparesTheYawOfALateFrameWithTheYawAtItsExposure) {
  Body body;
  AttitudeEstimator estimator = DefaultAttitudeEstimator();
  const Vector3d rate_B(0.0, 0.0, 2.0);
  Feed(estimator, body, 0.1, false);
  for (int i = 0; i < 200; ++i) {
    const double yaw_then = body.attitude().yaw;
    const Tick then = body.tick;
    Feed(estimator, body, 0.035, false, rate_B);
    estimator.CorrectYaw(then, yaw_then);
  }
  EXPECT_NEAR(models::WrapToPi(estimator.attitude().yaw - body.attitude().yaw), 0.0, 0.01);
}

TEST(AttitudeEstimator, CorrectsYawModulo180Degrees) {
  Body body({.yaw = 0.2});
  AttitudeEstimator estimator = DefaultAttitudeEstimator();
  Feed(estimator, body, 0.1, false);
  estimator.CorrectYaw(body.tick, 0.2);
  for (int i = 0; i < 300; ++i) {
    estimator.Update(body.Step(), false);
    estimator.CorrectYaw(body.tick, 0.2 - models::kPi);
  }
  EXPECT_NEAR(estimator.attitude().yaw, 0.2, 1e-3);
}

TEST(AttitudeEstimator, EstimatesTheYawGyroBiasFromVision) {
  Body body;
  body.gyro_bias.z() = 0.0087;
  AttitudeEstimator estimator = DefaultAttitudeEstimator();
  for (int i = 0; i < 12000; ++i) {
    estimator.Update(body.Step(), false);
    if (i % 3 == 0) estimator.CorrectYaw(body.tick, 0.0);
  }
  EXPECT_NEAR(estimator.gyro_bias_B().z(), 0.0087, 0.002);
}

TEST(AttitudeEstimator, IgnoresAFrameOlderThanTheHistory) {
  Body body;
  AttitudeEstimator estimator = DefaultAttitudeEstimator();
  Feed(estimator, body, 2.0, false);
  estimator.CorrectYaw(body.tick - kTime.FromSeconds(1.0), 1.0);
  EXPECT_NEAR(estimator.attitude().yaw, 0.0, 1e-6);
}

TEST(AttitudeEstimator, ReportsGravityAtAnEarlierTick) {
  Body body;
  AttitudeEstimator estimator = DefaultAttitudeEstimator();
  EXPECT_EQ(estimator.GravityAt(0), -Vector3d::UnitZ());
  Feed(estimator, body, 0.5, false);
  const Vector3d before = body.gravity_B();
  const Tick then = body.tick;
  Feed(estimator, body, 0.1, false, {3.0, 0.0, 0.0});
  EXPECT_NEAR((estimator.GravityAt(then + 3) - before).norm(), 0.0, 2e-3);
  EXPECT_NEAR((estimator.GravityAt(body.tick) - body.gravity_B()).norm(), 0.0, 2e-3);
  EXPECT_NEAR((estimator.GravityAt(0) - before).norm(), 0.0, 2e-3);  // The oldest sample in the history.
}

TEST(AttitudeEstimatorConfig, RejectsInvalidValues) {
  EXPECT_NO_THROW(AttitudeEstimatorConfig{}.Validate());
  AttitudeEstimatorConfig config;
  config.history_s = 0.0;
  EXPECT_THROW(config.Validate(), InputError);
  config = {};
  config.level_ground_tolerance_deg = -0.1;
  EXPECT_THROW(config.Validate(), InputError);
  config = {};
  config.gyro_bias_time_constant_s = config.accelerometer_time_constant_s;
  EXPECT_THROW(AttitudeEstimator(config, kTime, Matrix3d::Identity()), InputError);
}

}  // namespace
}  // namespace touchdown::estimator
