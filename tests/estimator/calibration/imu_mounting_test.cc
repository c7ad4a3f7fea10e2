#include "estimator/calibration/imu_mounting.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "models/angles.h"
#include "models/random_stream.h"
#include "models/vehicle.h"
#include "tests/support/throws_input_error.h"

namespace touchdown::estimator::calibration {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using ::testing::HasSubstr;
using tests::ThrowsInputError;
using Samples = std::vector<models::ImuSample>;

const Vector3d kUp = Vector3d::UnitZ();

/// Samples of an IMU on a level body at rest.
Samples AtRest(const Matrix3d& R_BU, int count, double noise_m_s2 = 0.0, std::uint64_t seed = 1) {
  models::RandomStream random(seed, "test");
  Samples samples;
  for (int i = 0; i < count; ++i) {
    samples.push_back({.tick = 6 * i,
                       .specific_force_U = R_BU.transpose() * Vector3d(0.0, 0.0, models::kGravity_m_s2) +
                                           noise_m_s2 * random.NormalVector3()});
  }
  return samples;
}

TEST(ImuMounting, IsExactForSamplesWithoutNoise) {
  models::RandomStream random(7, "tilts");
  for (int i = 0; i < 200; ++i) {
    const Vector3d axis = Vector3d(random.Normal(), random.Normal(), 0.0).normalized();
    const Matrix3d R_BU = models::RotationExp(random.Uniform(0.0, 3.1) * axis);
    const ImuMounting estimated = FindImuMounting(AtRest(R_BU, 100));
    EXPECT_LT(models::RotationLog(estimated.R_BU.transpose() * R_BU).norm(), 1e-9);
    EXPECT_LT(estimated.noise_sigma_rad, 1e-12);
    EXPECT_EQ(estimated.samples, 100u);
  }
}

TEST(ImuMounting, ReturnsTheShortestRotation) {
  const Matrix3d R_BU = models::RotationFromTaitBryan({.roll = 0.03, .pitch = -0.02, .yaw = 0.7});
  const Matrix3d estimated = FindImuMounting(AtRest(R_BU, 100)).R_BU;
  EXPECT_TRUE((estimated * R_BU.transpose() * kUp).isApprox(kUp, 1e-12)) << "gravity is not vertical";
  EXPECT_NEAR(models::RotationLog(estimated).z(), 0.0, 1e-12) << "the rotation axis is not horizontal";
  EXPECT_NEAR(models::RotationLog(estimated).norm(), std::acos(R_BU(2, 2)), 1e-9);
}

TEST(ImuMounting, HandlesAnImuMountedUpsideDown) {
  const Matrix3d R_BU = models::RotationExp(Vector3d(models::kPi, 0.0, 0.0));
  const Matrix3d estimated = FindImuMounting(AtRest(R_BU, 100)).R_BU;
  EXPECT_TRUE((estimated * R_BU.transpose() * kUp).isApprox(kUp, 1e-12));
  EXPECT_NEAR(estimated.determinant(), 1.0, 1e-12);
}

TEST(ImuMounting, InterpretsTheAccelerometerBiasAsTilt) {
  Samples samples = AtRest(Matrix3d::Identity(), 100);
  for (auto& sample : samples) sample.specific_force_U.y() += 0.196;
  const models::TaitBryan estimated = models::TaitBryanFromRotation(FindImuMounting(samples).R_BU);
  EXPECT_NEAR(models::RadToDeg(estimated.roll), models::RadToDeg(std::atan2(0.196, 9.81)), 1e-9);
}

TEST(ImuMounting, PredictsTheErrorDueToNoise) {
  const double noise_m_s2 = 0.05;
  for (const int count : {100, 10000}) {
    double squared_rad2 = 0.0, predicted_rad = 0.0;
    const int runs = count == 100 ? 200 : 20;
    for (int seed = 0; seed < runs; ++seed) {
      const auto estimated =
          FindImuMounting(AtRest(Matrix3d::Identity(), count, noise_m_s2, static_cast<unsigned>(seed)));
      squared_rad2 += models::RotationLog(estimated.R_BU).squaredNorm() / (2.0 * runs);
      predicted_rad += estimated.noise_sigma_rad / runs;
    }
    EXPECT_NEAR(std::sqrt(squared_rad2) / predicted_rad, 1.0, 0.35) << count;
    EXPECT_NEAR(predicted_rad, noise_m_s2 / models::kGravity_m_s2 / std::sqrt(count), 0.3 * predicted_rad);
  }
}

TEST(ImuMounting, RejectsTooFewSamplesMotionWrongGravityAndNonFiniteValues) {
  EXPECT_THAT([&] { FindImuMounting({}); },
              ThrowsInputError("too few samples of the IMU at rest: 0; at least 100 are needed"));
  EXPECT_THAT([&] { FindImuMounting(AtRest(Matrix3d::Identity(), 99)); },
              ThrowsInputError("too few samples of the IMU at rest: 99; at least 100 are needed"));
  EXPECT_NO_THROW(FindImuMounting(AtRest(Matrix3d::Identity(), 100)));
  EXPECT_THAT([&] { FindImuMounting(AtRest(Matrix3d::Identity(), 500, 0.5)); },
              ThrowsInputError(HasSubstr("not at rest: the standard deviation of its specific force is 0.5")));
  Samples turning = AtRest(Matrix3d::Identity(), 100);
  for (auto& sample : turning) sample.w_WU_U.z() = 0.2;
  EXPECT_THAT([&] { FindImuMounting(turning); },
              ThrowsInputError(HasSubstr("not at rest: its mean angular rate is 0.20 rad/s")));
  Samples falling = AtRest(Matrix3d::Identity(), 100);
  for (auto& sample : falling) sample.specific_force_U /= models::kGravity_m_s2;
  EXPECT_THAT([&] { FindImuMounting(falling); },
              ThrowsInputError(HasSubstr("1.00 m/s^2; allowed: within 1.00 m/s^2 of gravity")));
  Samples broken = AtRest(Matrix3d::Identity(), 100);
  broken[50].specific_force_U.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT([&] { FindImuMounting(broken); }, ThrowsInputError(HasSubstr("not finite")));
}

}  // namespace
}  // namespace touchdown::estimator::calibration
