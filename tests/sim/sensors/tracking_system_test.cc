#include "sim/sensors/tracking_system.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "models/angles.h"
#include "models/error.h"
#include "tests/support/nominal.h"

namespace touchdown::sim {
namespace {

using Eigen::Vector3d;
using tests::kTime;

TrueState Somewhere() {
  TrueState truth;
  truth.X_WB.linear() = models::RotationFromTaitBryan({.roll = 0.1, .pitch = 0.2, .yaw = 1.0});
  truth.X_WB.translation() = Vector3d(0.5, -0.4, 1.2);
  return truth;
}

struct Sampled {
  models::Tick tick = 0;
  std::optional<Vector3d> position_error;
  Vector3d rotation_error = Vector3d::Zero();
};

/// All samples of a vehicle at rest over a duration. Gaps have no position error.
std::vector<Sampled> Track(const TrackingSystemConfig& config, double duration_s, std::uint64_t seed) {
  TrackingSystem tracking(config, kTime, seed);
  std::vector<Sampled> samples;
  TrueState truth = Somewhere();
  for (; truth.tick < kTime.FromSeconds(duration_s); ++truth.tick) {
    const auto pose = tracking.Sample(truth);
    if (truth.tick % kTime.PeriodOf(config.rate_hz) != 0) {
      EXPECT_FALSE(pose) << "at tick " << truth.tick;
      continue;
    }
    Sampled sample{.tick = truth.tick, .position_error = std::nullopt};
    if (pose) {
      EXPECT_EQ(pose->tick, truth.tick);
      sample.position_error = pose->X_WB.translation() - truth.X_WB.translation();
      sample.rotation_error = models::RotationLog(truth.X_WB.linear().transpose() * pose->X_WB.linear());
    }
    samples.push_back(sample);
  }
  return samples;
}

TEST(TrackingSystem, HasTheNoiseOfItsConfig) {
  const TrackingSystemConfig config{
      .position_noise_m = 0.003, .rotation_noise_deg = models::RadToDeg(0.01), .occlusions_per_s = 0.0};
  const auto samples = Track(config, 100.0, 1);
  ASSERT_EQ(samples.size(), 10000U);
  Vector3d mean = Vector3d::Zero(), position2 = Vector3d::Zero(), rotation2 = Vector3d::Zero();
  for (const auto& sample : samples) {
    ASSERT_TRUE(sample.position_error);
    mean += *sample.position_error / 10000.0;
    position2 += sample.position_error->cwiseAbs2() / 10000.0;
    rotation2 += sample.rotation_error.cwiseAbs2() / 10000.0;
  }
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(mean[axis], 0.0, 0.00015);
    EXPECT_NEAR(std::sqrt(position2[axis]), 0.003, 0.0001);
    EXPECT_NEAR(std::sqrt(rotation2[axis]), 0.01, 0.0003);
  }
}

TEST(TrackingSystem, OcclusionsHaveTheConfiguredRateAndDuration) {
  const TrackingSystemConfig config{.occlusions_per_s = 0.5, .occlusion_duration_s = 0.4, .outlier_probability = 0.0};
  const auto samples = Track(config, 2000.0, 2);
  int gaps = 0, missing = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    missing += !samples[i].position_error;
    gaps += !samples[i].position_error && samples[i - 1].position_error;
  }
  const double cycle_s = 1.0 / 0.5 + 0.4;
  EXPECT_NEAR(missing / static_cast<double>(samples.size()), 0.4 / cycle_s, 0.02);
  EXPECT_NEAR(gaps / 2000.0, 1.0 / cycle_s, 0.04);
}

TEST(TrackingSystem, OutliersHaveAConstantOffsetOverAnOcclusion) {
  const TrackingSystemConfig config{.position_noise_m = 0.0,
                                    .rotation_noise_deg = 0.0,
                                    .occlusions_per_s = 0.2,
                                    .occlusion_duration_s = 0.5,
                                    .outlier_probability = 1.0};
  std::vector<Vector3d> offsets;
  for (const auto& sample : Track(config, 3000.0, 3)) {
    ASSERT_TRUE(sample.position_error) << "there must be no gaps";
    if (sample.position_error->norm() < 1e-9) continue;
    if (offsets.empty() || (*sample.position_error - offsets.back()).norm() > 1e-9) {
      offsets.push_back(*sample.position_error);
    }
  }
  ASSERT_GT(offsets.size(), 400U);
  double sum2 = 0.0;
  for (const Vector3d& offset : offsets) sum2 += offset.squaredNorm() / 3.0;
  EXPECT_NEAR(std::sqrt(sum2 / static_cast<double>(offsets.size())), config.outlier_position_m, 0.012);
}

TEST(TrackingSystem, HasGapsAndOutliers) {
  int gaps = 0, outliers = 0;
  for (const auto& sample : Track({.occlusions_per_s = 0.5}, 600.0, 4)) {
    if (!sample.position_error) {
      ++gaps;
    } else if (sample.position_error->norm() > 0.02) {
      ++outliers;
    }
  }
  EXPECT_GT(gaps, 500);
  EXPECT_GT(outliers, 500);
}

TEST(TrackingSystem, OcclusionsDoNotChangeTheNoiseOfOtherSamples) {
  const auto clear = Track({.occlusions_per_s = 0.0}, 60.0, 5);
  const auto occluded = Track({.occlusions_per_s = 0.5, .outlier_probability = 0.0}, 60.0, 5);
  int tracked = 0;
  for (std::size_t i = 0; i < clear.size(); ++i) {
    if (!occluded[i].position_error) continue;
    ++tracked;
    EXPECT_EQ(*occluded[i].position_error, *clear[i].position_error);
  }
  EXPECT_LT(tracked, static_cast<int>(clear.size()));
}

TEST(TrackingSystem, RepeatsItselfWithTheSameSeedOnly) {
  const auto a = Track({}, 1.0, 6), b = Track({}, 1.0, 6), c = Track({}, 1.0, 7);
  EXPECT_EQ(a[3].position_error, b[3].position_error);
  EXPECT_NE(a[3].position_error, c[3].position_error);
}

TEST(TrackingSystemConfig, RejectsInvalidValues) {
  EXPECT_NO_THROW(TrackingSystemConfig{}.Validate(kTime));
  EXPECT_THROW(TrackingSystemConfig{.rate_hz = 7}.Validate(kTime), InputError);
  EXPECT_THROW(TrackingSystemConfig{.position_noise_m = -0.001}.Validate(kTime), InputError);
  EXPECT_THROW(TrackingSystemConfig{.rotation_noise_deg = std::nan("")}.Validate(kTime), InputError);
  EXPECT_THROW(TrackingSystemConfig{.occlusions_per_s = 1e9}.Validate(kTime), InputError);
  EXPECT_THROW(TrackingSystemConfig{.outlier_probability = 1.1}.Validate(kTime), InputError);
}

}  // namespace
}  // namespace touchdown::sim
