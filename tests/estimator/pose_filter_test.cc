#include "estimator/pose_filter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/error.h"
#include "models/random_stream.h"
#include "tests/support/nominal.h"

namespace touchdown::estimator {
namespace {

using Eigen::Vector3d;
using Motion = models::VehicleEstimate::Motion;
using tests::kTime;

const Eigen::Matrix3d kCovariance = 1e-4 * Eigen::Matrix3d::Identity();

PoseFilter DefaultFilter() { return {PoseFilterConfig{}, kTime}; }

TEST(PoseFilter, HasNoStateBeforeTheFirstPosition) {
  const PoseFilter filter = DefaultFilter();
  EXPECT_FALSE(filter.At(100).has_value());
  EXPECT_FALSE(filter.newest().has_value());
}

TEST(PoseFilter, StartsAtTheFirstPositionWithZeroVelocity) {
  PoseFilter filter = DefaultFilter();
  filter.Update(40, {1.0, 2.0, 3.0}, kCovariance);
  const auto motion = filter.At(60);
  ASSERT_TRUE(motion.has_value());
  EXPECT_EQ(motion->p_WB, Vector3d(1.0, 2.0, 3.0));
  EXPECT_EQ(motion->v_WB, Vector3d::Zero());
  EXPECT_EQ(filter.newest(), 40);
}

TEST(PoseFilter, ConvergesToAConstantVelocityForIrregularFrames) {
  PoseFilter filter = DefaultFilter();
  models::RandomStream random(1, "pose_filter_test");
  const Vector3d p0(0.3, -0.2, 1.0), v(0.2, -0.1, 0.05);
  models::Tick tick = 0;
  for (int i = 0; i < 200; ++i) {
    filter.Update(tick, p0 + kTime.ToSeconds(tick) * v, kCovariance);
    tick += random.UniformInt(5, 60);
  }
  const models::Tick later = *filter.newest() + 48;
  const Motion motion = *filter.At(later);
  EXPECT_NEAR((motion.v_WB - v).norm(), 0.0, 1e-4);
  EXPECT_NEAR((motion.p_WB - (p0 + kTime.ToSeconds(later) * v)).norm(), 0.0, 1e-4);
}

/// RMSE of (position, velocity) for positions at 60 Hz with white noise.
Eigen::Vector2d ErrorsAtRest(VisionNoise source, double height_m, const Vector3d& noise) {
  PoseFilterConfig config;
  config.vision_noise = source;
  PoseFilter filter(config, kTime);
  models::RandomStream random(7, "pose_filter_test.noise");
  double p_sum = 0.0, v_sum = 0.0;
  constexpr int kFrames = 4000, kWarmUp = 100;
  for (int i = 0; i < kFrames; ++i) {
    filter.Update(20 * i, Vector3d(0.0, 0.0, height_m) + noise.cwiseProduct(random.NormalVector3()),
                  noise.cwiseAbs2().asDiagonal());
    if (i < kWarmUp) continue;
    const Motion motion = *filter.At(20 * i + 24);
    p_sum += motion.p_WB.head<2>().squaredNorm() / 2.0;
    v_sum += motion.v_WB.head<2>().squaredNorm() / 2.0;
  }
  return Eigen::Vector2d(p_sum, v_sum).cwiseSqrt() / std::sqrt(kFrames - kWarmUp);
}

TEST(PoseFilter, ReducesTheNoise) {
  for (const VisionNoise source : {VisionNoise::kHeight, VisionNoise::kCovariance}) {
    const Eigen::Vector2d errors = ErrorsAtRest(source, 1.0, {0.02, 0.02, 0.005});
    EXPECT_LT(errors[0], 0.013);
    EXPECT_LT(errors[1], 0.10);
  }
}

TEST(PoseFilter, WeightsHorizontalPositionsMoreAtLowHeight) {
  const Vector3d noise(0.01, 0.01, 0.002);
  EXPECT_LT(ErrorsAtRest(VisionNoise::kHeight, 1.5, noise)[1],
            0.7 * ErrorsAtRest(VisionNoise::kHeight, 0.25, noise)[1]);
}

TEST(PoseFilter, FollowsAnAccelerationWithASmallLag) {
  PoseFilter filter = DefaultFilter();
  const double a = 1.0;
  for (int i = 0; i <= 120; ++i) {
    const double t = i / 60.0;
    filter.Update(20 * i, {0.5 * a * t * t, 0.0, 1.0}, kCovariance);
  }
  const Motion motion = *filter.At(20 * 120);
  EXPECT_NEAR(motion.v_WB.x(), 2.0 * a, 0.20 * a);
  EXPECT_NEAR(motion.p_WB.x(), 2.0 * a, 0.03 * a);
}

TEST(PoseFilter, ConvergesAfterAGapInTheFrames) {
  PoseFilter filter = DefaultFilter();
  for (int i = 0; i < 60; ++i) filter.Update(20 * i, {0.0, 0.0, 1.0}, kCovariance);
  const models::Tick again = 20 * 60 + 2400;
  for (int i = 0; i < 30; ++i) filter.Update(again + 20 * i, {0.6, 0.0, 1.2}, kCovariance);
  EXPECT_NEAR((filter.At(*filter.newest())->p_WB - Vector3d(0.6, 0.0, 1.2)).norm(), 0.0, 0.03);
  EXPECT_LT(filter.At(*filter.newest())->v_WB.norm(), 0.2);
}

TEST(PoseFilter, IgnoresAFrameThatIsNotNewer) {
  PoseFilter filter = DefaultFilter();
  filter.Update(40, {0.0, 0.0, 1.0}, kCovariance);
  filter.Update(40, {5.0, 0.0, 1.0}, kCovariance);
  filter.Update(20, {5.0, 0.0, 1.0}, kCovariance);
  EXPECT_EQ(filter.At(40)->p_WB, Vector3d(0.0, 0.0, 1.0));
  EXPECT_EQ(filter.newest(), 40);
}

TEST(PoseFilterConfig, RejectsInvalidValues) {
  EXPECT_NO_THROW(PoseFilterConfig{}.Validate());
  PoseFilterConfig config;
  config.min_z_noise_m = 0.0;
  EXPECT_THROW(config.Validate(), InputError);
  config = {};
  config.initial_speed_m_s = NAN;
  EXPECT_THROW(PoseFilter(config, kTime), InputError);
}

TEST(PoseFilter, FollowsAPreciseFrameMoreThanOneOfLargeCovariance) {
  PoseFilterConfig config;
  config.vision_noise = VisionNoise::kCovariance;
  const auto after_a_step = [&](double variance_m2) {
    PoseFilter filter(config, kTime);
    for (int i = 0; i < 60; ++i) filter.Update(20 * i, {0.0, 0.0, 1.0}, kCovariance);
    filter.Update(1200, {0.1, 0.0, 1.0}, variance_m2 * Eigen::Matrix3d::Identity());
    return filter.At(1200)->p_WB.x();
  };
  EXPECT_GT(after_a_step(1e-5), 2.0 * after_a_step(1e-3));
}

}  // namespace
}  // namespace touchdown::estimator
