#include "sim/sensors/imu.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "models/angles.h"
#include "models/error.h"
#include "sim/dynamics/world.h"
#include "tests/support/nominal.h"
#include "tests/support/worlds.h"

namespace touchdown::sim {
namespace {

using Eigen::Vector3d;
using tests::kG;
using tests::kTime;

ImuConfig PerfectImu() {
  return {.gyro_noise_rad_s_sqrt_hz = 0.0,
          .accelerometer_noise_m_s2_sqrt_hz = 0.0,
          .gyro_bias_sigma_deg_s = 0.0,
          .accelerometer_bias_sigma_m_s2 = 0.0};
}

/// Samples of an IMU at rest.
std::vector<models::ImuSample> AtRest(Imu& imu, int count) {
  std::vector<models::ImuSample> samples;
  for (TrueState truth; static_cast<int>(samples.size()) < count; ++truth.tick) {
    if (const auto sample = imu.Sample(truth)) samples.push_back(*sample);
  }
  return samples;
}

TEST(Imu, SamplesAtItsRateFromTickZero) {
  Imu imu({.rate_hz = 200}, Eigen::Isometry3d::Identity(), kTime, 1);
  const auto samples = AtRest(imu, 5);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(samples[i].tick, 6 * i);
}

TEST(Imu, MeasuresGravityUpwardsAtRest) {
  Imu imu(PerfectImu(), Eigen::Isometry3d::Identity(), kTime, 1);
  for (const auto& sample : AtRest(imu, 3)) {
    EXPECT_TRUE(sample.specific_force_U.isApprox(Vector3d(0.0, 0.0, kG), 1e-12));
    EXPECT_EQ(sample.w_WU_U, Vector3d::Zero());
  }
}

TEST(Imu, MeasuresGravityInItsOwnAxesWhenMisaligned) {
  models::Vehicle vehicle;
  vehicle.imu.misalignment_deg = {.roll = 6.0, .pitch = -12.0, .yaw = 17.0};
  Imu imu(PerfectImu(), vehicle.X_BU(), kTime, 1);
  TrueState truth;
  truth.X_WB.linear() = models::RotationFromTaitBryan({.roll = 0.4, .pitch = 0.1, .yaw = -2.0});
  const Vector3d up_U = vehicle.X_BU().linear().transpose() * truth.X_WB.linear().transpose() * Vector3d::UnitZ();
  EXPECT_TRUE(imu.Sample(truth)->specific_force_U.isApprox(kG * up_U, 1e-12));
}

TEST(Imu, MeasuresCentripetalAndTangentialAccelerationOffTheCenter) {
  Eigen::Isometry3d X_BU = Eigen::Isometry3d::Identity();
  X_BU.translation() = Vector3d(0.1, 0.0, 0.0);
  Imu imu(PerfectImu(), X_BU, models::TimeBase{.ticks_per_s = 200000}, 1);
  TrueState truth;
  truth.w_WB_B = Vector3d(0.0, 0.0, 3.0);
  truth.alpha_WB_B = Vector3d(0.0, 0.0, 20.0);
  const Vector3d expected(-0.1 * 9.0, 0.1 * 20.0, kG);
  EXPECT_LT((imu.Sample(truth)->specific_force_U - expected).norm(), 1e-3);
}

/// Compares a strapdown integration of the samples with the truth, in a flight with rotation and lateral motion.
TEST(Imu, IntegratesToTheTrueVelocityAndAttitude) {
  models::Vehicle vehicle;
  vehicle.imu = {.position_m = {0.03, -0.02, 0.04}, .misalignment_deg = {3.0, -2.0, 23.0}};
  World world = tests::QuietWorld(vehicle);
  world.Reset(tests::LevelPose(0.0, 0.0, 20.0), true);
  const Eigen::Isometry3d X_BU = vehicle.X_BU();
  Imu imu(PerfectImu(), X_BU, kTime, 1);
  imu.Sample(world.state());

  Eigen::Matrix3d R_WU = world.state().X_WB.linear() * X_BU.linear();
  Vector3d v_WU = Vector3d::Zero();
  for (int tick = 1; tick <= 1200; ++tick) {
    const double phase = 2.0 * models::kPi * kTime.ToSeconds(tick);
    world.SetPush({4.0 * std::sin(phase), 3.0, 0.0}, {0.15 * std::cos(2.0 * phase), 0.1 * std::cos(phase), 0.04});
    world.Step(tests::HoverCommand(vehicle));
    if (const auto sample = imu.Sample(world.state())) {
      constexpr double kPeriod_s = 1.0 / 200.0;
      const Eigen::Matrix3d R_WU_middle = R_WU * models::RotationExp(0.5 * kPeriod_s * sample->w_WU_U);
      v_WU += kPeriod_s * (R_WU_middle * sample->specific_force_U - Vector3d(0.0, 0.0, kG));
      R_WU = R_WU * models::RotationExp(kPeriod_s * sample->w_WU_U);
    }
  }
  const TrueState& truth = world.state();
  const Eigen::Matrix3d R_WU_true = truth.X_WB.linear() * X_BU.linear();
  const Vector3d v_WU_true = truth.v_WB + truth.X_WB.linear() * truth.w_WB_B.cross(X_BU.translation());
  EXPECT_GT(truth.w_WB_B.norm(), 1.0);
  EXPECT_LT(models::RotationLog(R_WU.transpose() * R_WU_true).norm(), 1e-3);
  EXPECT_LT((v_WU - v_WU_true).norm(), 5e-3);
}

TEST(Imu, DampsTheVibrationOfTheRotorsInsteadOfAliasingIt) {
  World world(tests::Unpainted(), models::Vehicle{}, tests::EmptyRoom(), kTime, 2);
  world.Reset(tests::LevelPose(0.0, 0.0, 2.0), true);
  Imu imu(PerfectImu(), Eigen::Isometry3d::Identity(), kTime, 1);
  double raw = 0.0, sampled = 0.0;
  int samples = 0;
  for (int tick = 0; tick < 600; ++tick) {
    world.Step(tests::HoverCommand({}));
    raw += world.state().vibration_m_s2_B.squaredNorm() / 600.0;
    if (const auto sample = imu.Sample(world.state())) {
      sampled += sample->specific_force_U.head<2>().squaredNorm();
      ++samples;
    }
  }
  EXPECT_GT(std::sqrt(sampled / samples), 0.5 * std::sqrt(raw)) << "the samples contain vibration";
  EXPECT_LT(std::sqrt(sampled / samples), 0.9 * std::sqrt(raw));
}

TEST(Imu, HasWhiteNoiseOfTheGivenDensity) {
  ImuConfig config = PerfectImu();
  config.gyro_noise_rad_s_sqrt_hz = 1e-3;
  config.accelerometer_noise_m_s2_sqrt_hz = 5e-3;
  for (const int rate_hz : {100, 400}) {
    config.rate_hz = rate_hz;
    Imu imu(config, Eigen::Isometry3d::Identity(), kTime, 5);
    constexpr int kCount = 20000;
    const auto samples = AtRest(imu, kCount);
    Vector3d gyro2 = Vector3d::Zero(), force2 = Vector3d::Zero(), lag1 = Vector3d::Zero();
    for (int i = 0; i < kCount; ++i) {
      const Vector3d force = samples[i].specific_force_U - Vector3d(0.0, 0.0, kG);
      gyro2 += samples[i].w_WU_U.cwiseAbs2() / kCount;
      force2 += force.cwiseAbs2() / kCount;
      if (i > 0) lag1 += samples[i].w_WU_U.cwiseProduct(samples[i - 1].w_WU_U) / kCount;
    }
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(std::sqrt(gyro2[axis] / rate_hz), 1e-3, 3e-5);
      EXPECT_NEAR(std::sqrt(force2[axis] / rate_hz), 5e-3, 1.5e-4);
      EXPECT_LT(std::abs(lag1[axis] / gyro2[axis]), 0.03) << "the noise is white";
    }
  }
}

TEST(Imu, HasAConstantBiasPerFlightDrawnFromItsSeed) {
  ImuConfig config = PerfectImu();
  config.gyro_bias_sigma_deg_s = models::RadToDeg(0.01);
  config.accelerometer_bias_sigma_m_s2 = 0.2;
  constexpr int kFlights = 2000;
  Vector3d gyro2 = Vector3d::Zero(), force2 = Vector3d::Zero(), gyro_sum = Vector3d::Zero();
  for (int seed = 0; seed < kFlights; ++seed) {
    Imu imu(config, Eigen::Isometry3d::Identity(), kTime, static_cast<std::uint64_t>(seed));
    const auto samples = AtRest(imu, 3);
    EXPECT_EQ(samples[0].w_WU_U, samples[2].w_WU_U);
    gyro_sum += samples[0].w_WU_U / kFlights;
    gyro2 += samples[0].w_WU_U.cwiseAbs2() / kFlights;
    force2 += (samples[0].specific_force_U - Vector3d(0.0, 0.0, kG)).cwiseAbs2() / kFlights;
  }
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(gyro_sum[axis], 0.0, 0.001);
    EXPECT_NEAR(std::sqrt(gyro2[axis]), 0.01, 0.0006);
    EXPECT_NEAR(std::sqrt(force2[axis]), 0.2, 0.012);
  }
}

TEST(Imu, SaturatesAtItsRanges) {
  const ImuConfig config;
  Imu imu(config, Eigen::Isometry3d::Identity(), kTime, 1);
  TrueState truth;
  truth.w_WB_B = Vector3d(20.0, -20.0, 0.0);
  truth.a_WB = Vector3d(200.0, -200.0, 0.0);
  const auto sample = imu.Sample(truth);
  EXPECT_EQ(sample->w_WU_U.x(), models::DegToRad(config.gyro_range_deg_s));
  EXPECT_EQ(sample->w_WU_U.y(), -models::DegToRad(config.gyro_range_deg_s));
  EXPECT_EQ(sample->specific_force_U.lpNorm<Eigen::Infinity>(), config.accelerometer_range_m_s2);
  EXPECT_LT(std::abs(sample->w_WU_U.z()), 0.1);
}

TEST(Imu, RepeatsItselfWithTheSameSeed) {
  Imu a({}, Eigen::Isometry3d::Identity(), kTime, 3), b({}, Eigen::Isometry3d::Identity(), kTime, 3);
  const auto samples_a = AtRest(a, 50), samples_b = AtRest(b, 50);
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(samples_a[i].w_WU_U, samples_b[i].w_WU_U);
    EXPECT_EQ(samples_a[i].specific_force_U, samples_b[i].specific_force_U);
  }
}

TEST(ImuConfig, RejectsInvalidValues) {
  EXPECT_NO_THROW(ImuConfig{}.Validate(kTime));
  EXPECT_THROW(ImuConfig{.rate_hz = 0}.Validate(kTime), InputError);
  EXPECT_THROW(ImuConfig{.rate_hz = 170}.Validate(kTime), InputError);
  EXPECT_THROW(ImuConfig{.gyro_noise_rad_s_sqrt_hz = -1.0}.Validate(kTime), InputError);
  EXPECT_THROW(ImuConfig{.accelerometer_bias_sigma_m_s2 = std::nan("")}.Validate(kTime), InputError);
  EXPECT_THROW(ImuConfig{.gyro_range_deg_s = 0.0}.Validate(kTime), InputError);
  EXPECT_THROW(ImuConfig{.accelerometer_range_m_s2 = INFINITY}.Validate(kTime), InputError);
}

}  // namespace
}  // namespace touchdown::sim
