#include "estimator/pad/ellipse_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "models/angles.h"
#include "models/error.h"
#include "models/random_stream.h"

namespace touchdown::estimator::pad {
namespace {

using Eigen::Vector2d;

std::vector<Vector2d> PointsOn(const Ellipse& ellipse, int count, double noise = 0.0,
                               models::RandomStream* random = nullptr, double arc = 2.0 * models::kPi) {
  std::vector<Vector2d> points;
  for (int i = 0; i < count; ++i) {
    const double t = arc * i / count;
    Vector2d p = Vector2d(ellipse.semi_axes.x() * std::cos(t), ellipse.semi_axes.y() * std::sin(t));
    if (random != nullptr) p += noise * Vector2d(random->Normal(), random->Normal());
    points.push_back(ellipse.center + Eigen::Rotation2Dd(ellipse.angle) * p);
  }
  return points;
}

Ellipse RandomEllipse(models::RandomStream& random) {
  const double major = random.Uniform(10.0, 200.0);
  return {{random.Uniform(0.0, 640.0), random.Uniform(0.0, 480.0)},
          {major, major * random.Uniform(0.3, 0.95)},
          random.Uniform(-1.5, 1.5)};
}

void ExpectNear(const Ellipse& actual, const Ellipse& expected, double tolerance_px, double tolerance_rad) {
  EXPECT_LT((actual.center - expected.center).norm(), tolerance_px);
  EXPECT_LT((actual.semi_axes - expected.semi_axes).norm(), tolerance_px);
  EXPECT_LT(std::abs(models::WrapToHalfPi(actual.angle - expected.angle)), tolerance_rad);
}

TEST(EllipseFit, IsExactOnExactPoints) {
  models::RandomStream random(1, "tests.ellipse_fit");
  for (int i = 0; i < 200; ++i) {
    const Ellipse truth = RandomEllipse(random);
    const auto fit = FitEllipse(PointsOn(truth, 40));
    ASSERT_TRUE(fit);
    ExpectNear(*fit, truth, 1e-6, 1e-6);
  }
}

TEST(EllipseFit, FindsACircle) {
  const auto fit = FitEllipse(PointsOn({{320.0, 240.0}, {30.0, 30.0}, 0.0}, 60));
  ASSERT_TRUE(fit);
  EXPECT_LT((fit->center - Vector2d(320.0, 240.0)).norm(), 1e-9);
  EXPECT_NEAR(fit->semi_axes.x(), 30.0, 1e-6);
  EXPECT_NEAR(fit->semi_axes.y(), 30.0, 1e-6);
}

TEST(EllipseFit, IsExactOnAnArcOfAnEllipse) {
  const Ellipse truth{{100.0, 50.0}, {60.0, 40.0}, 0.4};
  const auto fit = FitEllipse(PointsOn(truth, 50, 0.0, nullptr, 2.0));
  ASSERT_TRUE(fit);
  ExpectNear(*fit, truth, 1e-4, 1e-5);
}

TEST(EllipseFit, AveragesNoise) {
  models::RandomStream random(2, "tests.ellipse_fit");
  const Ellipse truth{{320.0, 240.0}, {60.0, 40.0}, 0.5};
  Vector2d center_error = Vector2d::Zero(), axes_error = Vector2d::Zero();
  constexpr int kFits = 200;
  for (int i = 0; i < kFits; ++i) {
    const auto fit = FitEllipse(PointsOn(truth, 300, 0.3, &random));
    ASSERT_TRUE(fit);
    // 5 sigma: 0.3 px / sqrt(300 points), times about 2 for the sensitivity of each parameter.
    ExpectNear(*fit, truth, 0.25, 0.02);
    center_error += (fit->center - truth.center) / kFits;
    axes_error += (fit->semi_axes - truth.semi_axes) / kFits;
  }
  EXPECT_LT(center_error.norm(), 0.01);
  EXPECT_LT(axes_error.norm(), 0.02);
}

TEST(EllipseFit, AgreesWithOpenCvsDirectFit) {
  models::RandomStream random(3, "tests.ellipse_fit");
  for (int i = 0; i < 100; ++i) {
    const Ellipse truth = RandomEllipse(random);
    const auto points = PointsOn(truth, 120, 0.02 * truth.semi_axes.y(), &random);
    const auto ours = FitEllipse(points);
    ASSERT_TRUE(ours);
    std::vector<cv::Point2f> same;
    for (const Vector2d& p : points) same.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
    const cv::RotatedRect theirs = cv::fitEllipseDirect(same);
    const double major = 0.5 * std::max(theirs.size.width, theirs.size.height);
    const double minor = 0.5 * std::min(theirs.size.width, theirs.size.height);
    const double scale = 1e-3 * truth.semi_axes.x();
    EXPECT_NEAR(ours->center.x(), theirs.center.x, scale);
    EXPECT_NEAR(ours->center.y(), theirs.center.y, scale);
    EXPECT_NEAR(ours->semi_axes.x(), major, scale);
    EXPECT_NEAR(ours->semi_axes.y(), minor, scale);
  }
}

TEST(EllipseFit, FitsAnEllipseToThePointsOfARectangle) {
  std::vector<Vector2d> points;
  for (int i = 0; i <= 20; ++i) {
    for (const double side : {-1.0, 1.0}) {
      points.emplace_back(-10.0 + i, side * 4.0);
      points.emplace_back(side * 10.0, 4.0 * (i / 10.0 - 1.0));
    }
  }
  const auto fit = FitEllipse(points);
  ASSERT_TRUE(fit);
  EXPECT_LT(fit->center.norm(), 1e-9);
  EXPECT_LT(std::abs(fit->angle), 1e-9);
  EXPECT_GT(fit->semi_axes.x(), 1.5 * fit->semi_axes.y());
}

TEST(EllipseFit, ReturnsNulloptForPointsThatDetermineNoEllipse) {
  EXPECT_FALSE(FitEllipse({}));
  EXPECT_FALSE(FitEllipse(std::vector<Vector2d>{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 1.2}}));
  EXPECT_FALSE(FitEllipse(std::vector<Vector2d>(20, Vector2d(3.0, 4.0))));
  std::vector<Vector2d> line;
  for (int i = 0; i < 30; ++i) line.emplace_back(i, 2.0 * i + 1.0);
  EXPECT_FALSE(FitEllipse(line));
  line[3].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(FitEllipse(line));
}

TEST(Ellipse, ConicAndEllipseAreInversesOfEachOther) {
  models::RandomStream random(4, "tests.ellipse_fit");
  for (int i = 0; i < 100; ++i) {
    const Ellipse truth = RandomEllipse(random);
    for (const double scale : {1.0, -3.0}) {
      const auto again = Ellipse::FromConic(scale * truth.Conic());
      ASSERT_TRUE(again);
      ExpectNear(*again, truth, 1e-6, 1e-7);
    }
    for (const Vector2d& p : PointsOn(truth, 7)) {
      EXPECT_NEAR(p.homogeneous().dot(truth.Conic() * p.homogeneous()), 0.0, 1e-9);
      EXPECT_NEAR(DistanceFrom(truth, p), 0.0, 1e-9);
    }
    EXPECT_LT(truth.center.homogeneous().dot(truth.Conic() * truth.center.homogeneous()), 0.0);
  }
}

TEST(Ellipse, ReturnsNulloptForOtherConics) {
  EXPECT_FALSE(Ellipse::FromConic(Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal()));  // A hyperbola.
  EXPECT_FALSE(Ellipse::FromConic(Eigen::Vector3d(1.0, 1.0, 1.0).asDiagonal()));    // Empty.
  EXPECT_FALSE(Ellipse::FromConic(Eigen::Matrix3d::Zero()));
}

TEST(Ellipse, MeasuresTheDistanceOfNearbyPoints) {
  const Ellipse ellipse{{10.0, 20.0}, {40.0, 25.0}, 0.0};
  EXPECT_NEAR(DistanceFrom(ellipse, {50.1, 20.0}), 0.1, 1e-3);
  EXPECT_NEAR(DistanceFrom(ellipse, {10.0, 44.8}), -0.2, 2e-3);
  EXPECT_NEAR(RmsDistance(ellipse, std::vector<Vector2d>{{50.1, 20.0}, {10.0, 44.9}}), 0.1, 1e-3);
}

/// Points on the outer boundary of a ring of radius 50 px between two directions, with a wave of amplitude `wave_px`.
std::vector<Vector2d> RingPoints(double from_deg, double to_deg, double wave_px = 0.0) {
  std::vector<Vector2d> points;
  for (double deg = from_deg; deg < to_deg; deg += 1.0) {
    const double angle = models::DegToRad(deg), radius = 50.0 + wave_px * std::sin(5.0 * angle);
    points.emplace_back(100.0 + radius * std::cos(angle), 80.0 + radius * std::sin(angle));
  }
  return points;
}

TEST(FitRing, RemovesOutliers) {
  std::vector<Vector2d> points = RingPoints(0.0, 360.0);
  for (int i = 0; i < 40; ++i) points.emplace_back(110.0 + 0.5 * i, 80.0 + 0.3 * i);
  const auto ring = FitRing(points);
  ASSERT_TRUE(ring);
  EXPECT_EQ(points.size(), 360u);
  EXPECT_NEAR(ring->semi_axes.x(), 50.0, 1e-6);
  EXPECT_LT((ring->center - Vector2d(100.0, 80.0)).norm(), 1e-6);
}

TEST(FitRing, AcceptsCurledPaperButNotAnyOutline) {
  std::vector<Vector2d> curled = RingPoints(0.0, 360.0, 1.5), wild = RingPoints(0.0, 360.0, 8.0);
  EXPECT_TRUE(FitRing(curled));
  EXPECT_FALSE(FitRing(wild));
}

TEST(FitRing, RejectsAPartlyOccludedRing) {
  std::vector<Vector2d> most = RingPoints(0.0, 330.0, 1.0), part = RingPoints(0.0, 270.0, 1.0);
  EXPECT_TRUE(FitRing(most));
  EXPECT_FALSE(FitRing(part));
}

TEST(FitRing, RemovesPointsNextToAGap) {
  std::vector<Vector2d> points = RingPoints(0.0, 330.0);
  // The last points deviate from the ring along the occluding object, by up to 0.28 px.
  for (std::size_t i = 320; i < points.size(); ++i) {
    points[i] += 0.0004 * static_cast<double>(i - 310) * (points[i] - Vector2d(100.0, 80.0)) * 0.7;
  }
  const auto ring = FitRing(points);
  ASSERT_TRUE(ring);
  EXPECT_LT(points.size(), 320u);
  EXPECT_NEAR(ring->semi_axes.x(), 50.0, 1e-6);
  EXPECT_LT((ring->center - Vector2d(100.0, 80.0)).norm(), 1e-6);
}

TEST(FitRing, AcceptsSmallRingsOfIntegerPixels) {
  for (const double radius : {5.0, 6.0, 7.0, 9.0, 14.0}) {
    std::vector<Vector2d> points;
    for (double deg = 0.0; deg < 360.0; deg += 1.0) {
      const double angle = models::DegToRad(deg);
      const Vector2d pixel(
          (Vector2d(30.2, 20.7) + radius * Vector2d(std::cos(angle), std::sin(angle))).array().round());
      if (std::find(points.begin(), points.end(), pixel) == points.end()) points.push_back(pixel);
    }
    const std::size_t all = points.size();
    EXPECT_TRUE(FitRing(points)) << radius;
    EXPECT_GT(points.size(), 0.9 * static_cast<double>(all)) << radius;
  }
}

TEST(FitRing, RejectsInvalidSettings) {
  EXPECT_THROW((RingFitConfig{.tolerance_px = 0.0}.Validate()), InputError);
  EXPECT_THROW((RingFitConfig{.min_coverage = 1.1}.Validate()), InputError);
}

}  // namespace
}  // namespace touchdown::estimator::pad
