#include "estimator/pad/pose_covariance.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <vector>

#include "models/angles.h"
#include "models/error.h"
#include "models/random_stream.h"

namespace touchdown::estimator::pad {
namespace {

using Eigen::Vector2d;

std::vector<Vector2d> NoisyPoints(const Ellipse& ellipse, int count, double noise, models::RandomStream& random) {
  std::vector<Vector2d> points;
  for (int i = 0; i < count; ++i) {
    const double t = 2.0 * models::kPi * i / count;
    const Vector2d on_circle(std::cos(t), std::sin(t));
    const Vector2d normal = on_circle.cwiseQuotient(ellipse.semi_axes).normalized();
    points.push_back(ellipse.center + Eigen::Rotation2Dd(ellipse.angle) * (ellipse.semi_axes.cwiseProduct(on_circle) +
                                                                           noise * random.Normal() * normal));
  }
  return points;
}

TEST(EllipseParameters, ConvertToAnEllipseAndBack) {
  const Ellipse ellipse{{12.0, 34.0}, {50.0, 20.0}, -0.7};
  const auto again = EllipseOf(ParametersOf(ellipse));
  ASSERT_TRUE(again);
  EXPECT_LT((again->center - ellipse.center).norm(), 1e-9);
  EXPECT_LT((again->semi_axes - ellipse.semi_axes).norm(), 1e-9);
  EXPECT_NEAR(again->angle, ellipse.angle, 1e-9);
  EllipseParameters flat = ParametersOf(ellipse);
  flat(4) = -1.0;
  EXPECT_FALSE(EllipseOf(flat));
}

TEST(EllipseCovariance, MatchesTheScatterOfFitsToIndependentPoints) {
  models::RandomStream random(1, "tests.pose_covariance");
  const PoseCovarianceConfig config{.points_per_independent_point = 1.0};
  for (const Ellipse& truth :
       {Ellipse{{320.0, 240.0}, {30.0, 30.0}, 0.0}, Ellipse{{100.0, 200.0}, {80.0, 50.0}, 0.6}}) {
    double normalized_square = 0.0;
    constexpr int kFits = 400;
    for (int i = 0; i < kFits; ++i) {
      const auto points = NoisyPoints(truth, 180, 0.1, random);
      const auto fit = FitEllipse(points);
      ASSERT_TRUE(fit);
      const auto covariance = EllipseCovariance(*fit, points, config);
      ASSERT_TRUE(covariance);
      const EllipseParameters error = ParametersOf(*fit) - ParametersOf(truth);
      normalized_square += error.dot(covariance->ldlt().solve(error)) / kFits;
    }
    // Chi-square with five degrees of freedom: mean 5, standard deviation 0.16 over 400 fits.
    EXPECT_NEAR(normalized_square, 5.0, 0.8);
  }
}

TEST(EllipseCovariance, GrowsWhenPointsCoverOnlyAnArc) {
  models::RandomStream random(2, "tests.pose_covariance");
  const Ellipse ellipse{{0.0, 0.0}, {30.0, 20.0}, 0.0};
  auto points = NoisyPoints(ellipse, 180, 0.1, random);
  const auto whole = EllipseCovariance(ellipse, points);
  points.resize(60);
  const auto third = EllipseCovariance(ellipse, points);
  ASSERT_TRUE(whole && third);
  EXPECT_GT(third->trace(), 10.0 * whole->trace());
  points.resize(5);
  EXPECT_FALSE(EllipseCovariance(ellipse, points));
  EXPECT_FALSE(EllipseCovariance(ellipse, std::vector<Vector2d>(50, points[0])));
}

TEST(PoseCovariance, PropagatesALinearMapExactly) {
  const Ellipse ring{{320.0, 240.0}, {30.0, 25.0}, 0.0};
  Eigen::Matrix<double, 5, 5> covariance = Eigen::Matrix<double, 5, 5>::Zero();
  covariance.diagonal() << 0.04, 0.09, 1.0, 1.0, 1.0;
  covariance(0, 1) = covariance(1, 0) = 0.02;
  const PoseCovarianceConfig config{.added_position_sigma_m = 1e-9, .added_angle_sigma_rad = 1e-9};
  const auto pose_of = [&](const Ellipse& ellipse, double angle) -> std::optional<Eigen::Isometry3d> {
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.translation() << 0.01 * (ellipse.center - ring.center), 0.0;
    X.linear() = models::RotationExp({0.0, 0.0, angle});
    return X;
  };
  const auto propagated = PoseCovariance(ring, covariance, 0.0, 0.03, Eigen::Isometry3d::Identity(), pose_of, config);
  ASSERT_TRUE(propagated);
  EXPECT_NEAR((*propagated)(0, 0), 1e-4 * 0.04, 1e-9);
  EXPECT_NEAR((*propagated)(0, 1), 1e-4 * 0.02, 1e-9);
  EXPECT_NEAR((*propagated)(1, 1), 1e-4 * 0.09, 1e-9);
  EXPECT_NEAR((*propagated)(5, 5), 0.03 * 0.03, 1e-9);
  EXPECT_NEAR((*propagated)(2, 2), 0.0, 1e-9);
}

/// Variance of x for a pose with x = 0.01 m per px of the ellipse's center along u, which has a standard deviation of 1
/// px. Ellipses more than `limit_px` to the right of the mean have no pose.
std::optional<double> VarianceWithPosesUpTo(double limit_px) {
  const Ellipse ring{{320.0, 240.0}, {30.0, 25.0}, 0.0};
  Eigen::Matrix<double, 5, 5> covariance = 1e-6 * Eigen::Matrix<double, 5, 5>::Identity();
  covariance(0, 0) = 1.0;
  const auto pose_of = [&](const Ellipse& ellipse, double) -> std::optional<Eigen::Isometry3d> {
    const double u = ellipse.center.x() - ring.center.x();
    if (u > limit_px) return std::nullopt;
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.translation() << 0.01 * u, 0.0, 0.0;
    return X;
  };
  const auto propagated = PoseCovariance(ring, covariance, 0.0, 0.03, Eigen::Isometry3d::Identity(), pose_of,
                                         {.added_position_sigma_m = 1e-9, .added_angle_sigma_rad = 1e-9});
  if (!propagated) return std::nullopt;
  return (*propagated)(0, 0);
}

TEST(PoseCovariance, DoesNotShrinkWhereFarSigmaPointsHaveNoPose) {
  for (const double limit_px : {100.0, 2.0, 1.0, 0.1}) {
    const auto variance = VarianceWithPosesUpTo(limit_px);
    ASSERT_TRUE(variance) << limit_px;
    EXPECT_NEAR(*variance, 1e-4, 1e-9) << limit_px;
  }
}

TEST(PoseCovariance, ReturnsNulloptWhenTheNearestSigmaPointsHaveNoPose) { EXPECT_FALSE(VarianceWithPosesUpTo(0.01)); }

TEST(WrongBranchCovariance, IsTheSquareOfTheDifferenceTimesTheProbability) {
  Eigen::Isometry3d other = Eigen::Isometry3d::Identity();
  other.translation() << 0.1, 0.0, 0.0;
  other.linear() = models::RotationExp({0.0, 0.2, 0.0});
  const auto added = WrongBranchCovariance(Eigen::Isometry3d::Identity(), other, 0.25);
  EXPECT_NEAR(added(0, 0), 0.0025, 1e-12);
  EXPECT_NEAR(added(4, 4), 0.01, 1e-12);
  EXPECT_NEAR(added(0, 4), 0.005, 1e-12);
  EXPECT_NEAR(added(1, 1), 0.0, 1e-12);
}

TEST(StrokeSigma, GrowsWithNoiseAndWithTheAngleNotRectified) {
  const Ellipse letter{{0.0, 0.0}, {16.0, 9.0}, 0.0};
  const double good = StrokeSigma(letter, 150, 0.05, 0.0);
  EXPECT_LT(good, models::DegToRad(2.0));
  EXPECT_GT(StrokeSigma(letter, 150, 0.5, 0.0), good);
  EXPECT_GE(StrokeSigma(letter, 150, 0.05, 0.2), 0.2);
}

TEST(PoseCovarianceConfig, RejectsInvalidSettings) {
  EXPECT_THROW(PoseCovarianceConfig{.letter_sigma_rad = 0.0}.Validate(), InputError);
}

}  // namespace
}  // namespace touchdown::estimator::pad
