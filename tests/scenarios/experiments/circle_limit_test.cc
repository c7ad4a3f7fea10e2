#include "scenarios/experiments/circle_limit.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "models/angles.h"
#include "models/random_stream.h"
#include "tests/support/synthetic_pad.h"

namespace touchdown::experiments {
namespace {

using tests::CameraAbovePad;

constexpr double kRadius_m = 0.09;

/// Pose of a camera whose optical axis passes through the center of the pad.
Eigen::Isometry3d Centered(double distance_m, double tilt) {
  Eigen::Isometry3d X_WC = CameraAbovePad(Eigen::Vector3d::Zero(), 0.0, tilt);
  X_WC.translation() = -distance_m * X_WC.linear().col(2);
  return X_WC;
}

TEST(CircleLimit, GrowsInProportionToTheNoise) {
  const auto once = LimitForCircle({}, kRadius_m, Centered(1.0, 0.3), 0.01);
  const auto twice = LimitForCircle({}, kRadius_m, Centered(1.0, 0.3), 0.02);
  ASSERT_TRUE(once && twice);
  EXPECT_NEAR(twice->position_m, 2.0 * once->position_m, 1e-9);
  EXPECT_NEAR(twice->tilt_rad, 2.0 * once->tilt_rad, 1e-9);
}

TEST(CircleLimit, ReturnsNulloptForAFrontalView) {
  EXPECT_FALSE(LimitForCircle({.k1 = 0.0, .k2 = 0.0}, kRadius_m, Centered(1.0, 0.0), 0.01));
  EXPECT_TRUE(LimitForCircle({.k1 = 0.0, .k2 = 0.0}, kRadius_m, Centered(1.0, 0.1), 0.01));
}

TEST(CircleLimit, FallsWithTiltAndRisesWithDistance) {
  const auto limit = [](double distance_m, double tilt) {
    return LimitForCircle({}, kRadius_m, Centered(distance_m, tilt), 0.015)->tilt_rad;
  };
  EXPECT_LT(limit(1.0, 0.5), limit(1.0, 0.2));
  EXPECT_LT(limit(1.0, 0.2), limit(1.0, 0.05));
  EXPECT_LT(limit(0.5, 0.3), limit(1.0, 0.3));
}

// Computes the bound from pixels: the numerical derivatives of a finely sampled image of a disc with respect to the
// pose, with steps so small that an edge moves by much less than a pixel.
TEST(CircleLimit, MatchesTheInformationOfARenderedDisc) {
  const models::CameraModel camera{.width_px = 160,
                                   .height_px = 120,
                                   .fx_px = 160,
                                   .fy_px = 160,
                                   .cx_px = 79.5,
                                   .cy_px = 59.5,
                                   .k1 = 0.0,
                                   .k2 = 0.0};
  constexpr double kNoiseFraction = 0.02, kStep = 4e-4;
  const Eigen::Isometry3d X_WC = Centered(0.45, 0.8);
  constexpr int kSide = 16;                           // Samples along each side of a pixel.
  constexpr double kSample_m = 0.45 / 160.0 / kSide;  // Approximate distance of the samples on the ground.
  const auto render = [&](const Eigen::Isometry3d& X) {
    Eigen::VectorXd values(camera.width_px * camera.height_px);
    for (int v = 0; v < camera.height_px; ++v) {
      for (int u = 0; u < camera.width_px; ++u) {
        double inside = 0.0;
        for (int j = 0; j < kSide; ++j) {
          for (int i = 0; i < kSide; ++i) {
            const Eigen::Vector2d pixel(u - 0.5 + (i + 0.5) / kSide, v - 0.5 + (j + 0.5) / kSide);
            const Eigen::Vector3d ray = X.linear() * camera.NormalizedFromPixel(pixel).homogeneous();
            const Eigen::Vector3d p = X.translation() - ray * (X.translation().z() / ray.z());
            inside += std::clamp(0.5 + (kRadius_m - p.head<2>().norm()) / (2.0 * kSample_m), 0.0, 1.0);
          }
        }
        values[v * camera.width_px + u] = inside / (kSide * kSide);
      }
    }
    return values;
  };
  Eigen::MatrixXd derivatives(camera.width_px * camera.height_px, 5);
  for (int k = 0; k < 5; ++k) {
    const auto moved = [&](double step) {
      Eigen::Isometry3d X = X_WC;
      if (k < 3) X.translation()[k] += step;
      const Eigen::Vector3d rotation =
          k < 3 ? Eigen::Vector3d::Zero() : Eigen::Vector3d(step * Eigen::Vector3d::Unit(k - 3));
      X.linear() = models::RotationExp(rotation) * X_WC.linear();
      return render(X);
    };
    derivatives.col(k) = (moved(kStep) - moved(-kStep)) / (2.0 * kStep);
  }
  const Eigen::MatrixXd covariance =
      (derivatives.transpose() * derivatives / (kNoiseFraction * kNoiseFraction)).inverse();
  const auto limit = LimitForCircle(camera, kRadius_m, X_WC, kNoiseFraction);
  ASSERT_TRUE(limit);
  EXPECT_NEAR(limit->position_m, std::sqrt(covariance.topLeftCorner(3, 3).trace()), 0.1 * limit->position_m);
  EXPECT_NEAR(limit->tilt_rad, std::sqrt(covariance.bottomRightCorner(2, 2).trace()), 0.1 * limit->tilt_rad);
}

}  // namespace
}  // namespace touchdown::experiments
