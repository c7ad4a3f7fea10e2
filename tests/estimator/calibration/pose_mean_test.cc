#include "estimator/calibration/pose_mean.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "models/angles.h"
#include "models/error.h"
#include "models/random_stream.h"
#include "tests/support/random_pose.h"

namespace touchdown::estimator::calibration {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kPosition_m = 0.002, kRotation_rad = 0.0087;

std::vector<Isometry3d> Measurements(const Isometry3d& truth, int count, models::RandomStream& random) {
  std::vector<Isometry3d> measured(static_cast<std::size_t>(count), truth);
  for (Isometry3d& X : measured) {
    X.translation() += kPosition_m * random.NormalVector3();
    X.linear() = models::RotationExp(kRotation_rad * random.NormalVector3()) * truth.linear();
  }
  return measured;
}

double RotationBetween(const Isometry3d& a, const Isometry3d& b) {
  return models::RotationLog(a.linear() * b.linear().transpose()).norm();
}

TEST(PoseMean, EqualsIdenticalMeasurements) {
  models::RandomStream random(1, "test");
  for (int i = 0; i < 100; ++i) {
    const Isometry3d truth = tests::RandomPose(random);
    const PoseMean mean = MeanPose(std::vector<Isometry3d>(1 + i % 5, truth));
    EXPECT_TRUE(mean.X_AB.isApprox(truth, 1e-12));
    EXPECT_EQ(mean.used, static_cast<std::size_t>(1 + i % 5));
    EXPECT_LT(mean.position_scatter_m.norm() + mean.rotation_scatter_rad.norm(), 1e-7);
  }
}

TEST(PoseMean, IsHalfwayBetweenTwoPoses) {
  const Vector3d rotation(0.1, -0.2, 0.3);
  Isometry3d a = Isometry3d::Identity(), b = Isometry3d::Identity();
  b.linear() = models::RotationExp(rotation);
  b.translation() = Vector3d(2, 4, 6);
  const Isometry3d mean = MeanPose(std::vector{a, b}).X_AB;
  EXPECT_TRUE(mean.linear().isApprox(models::RotationExp(0.5 * rotation), 1e-12));
  EXPECT_TRUE(mean.translation().isApprox(Vector3d(1, 2, 3)));
}

TEST(PoseMean, EstimatesTheScatterAndTheErrorOfTheMean) {
  models::RandomStream random(2, "test");
  double position_ratio = 0.0, rotation_ratio = 0.0;
  constexpr int kRuns = 100;
  for (int run = 0; run < kRuns; ++run) {
    const Isometry3d truth = tests::RandomPose(random);
    const PoseMean mean = MeanPose(Measurements(truth, 400, random));
    EXPECT_NEAR(mean.position_scatter_m.norm(), std::sqrt(3.0) * kPosition_m, 0.1 * kPosition_m * std::sqrt(3.0));
    EXPECT_NEAR(mean.rotation_scatter_rad.norm(), std::sqrt(3.0) * kRotation_rad, 0.1 * kRotation_rad * std::sqrt(3.0));
    position_ratio +=
        (mean.X_AB.translation() - truth.translation()).squaredNorm() / mean.position_sigma_m().squaredNorm() / kRuns;
    rotation_ratio += std::pow(RotationBetween(mean.X_AB, truth), 2) / mean.rotation_sigma_rad().squaredNorm() / kRuns;
  }
  EXPECT_NEAR(position_ratio, 1.0, 0.3);
  EXPECT_NEAR(rotation_ratio, 1.0, 0.3);
}

TEST(PoseMean, IgnoresOutliers) {
  models::RandomStream random(3, "test");
  const Isometry3d truth = tests::RandomPose(random);
  std::vector<Isometry3d> measured = Measurements(truth, 100, random);
  for (std::size_t i = 0; i < 20; ++i) measured[i].translation() += Vector3d(0.15, -0.1, 0.1);
  for (std::size_t i = 10; i < 30; ++i) measured[i].linear() = measured[i].linear() * models::RotationExp({0.2, 0, 0});
  const PoseMean mean = MeanPose(measured);
  EXPECT_EQ(mean.used, 70u);
  EXPECT_LT((mean.X_AB.translation() - truth.translation()).norm(), 0.001);
  EXPECT_LT(RotationBetween(mean.X_AB, truth), 0.004);
}

TEST(PoseMean, RejectsNoMeasurementsAndNonFiniteValues) {
  EXPECT_THROW(MeanPose({}), InputError);
  Isometry3d broken = Isometry3d::Identity();
  broken.translation().x() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(MeanPose(std::vector{broken}), InputError);
}

}  // namespace
}  // namespace touchdown::estimator::calibration
