#include "models/camera_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "models/error.h"

namespace touchdown::models {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

CameraModel Pinhole() {
  CameraModel camera;
  camera.k1 = camera.k2 = 0.0;
  return camera;
}

CameraModel WithDistortion(double k1, double k2) {
  CameraModel camera;
  camera.k1 = k1;
  camera.k2 = k2;
  return camera;
}

TEST(CameraModel, HasAFieldOfViewOf90DegreesByDefault) {
  const CameraModel camera = Pinhole();
  EXPECT_NEAR(camera.Ray({-0.5, 239.5})->x() / camera.Ray({-0.5, 239.5})->z(), -1.0, 1e-12);
  EXPECT_NEAR(camera.Ray({639.5, 239.5})->x() / camera.Ray({639.5, 239.5})->z(), 1.0, 1e-12);
}

TEST(CameraModel, ProjectsWithXRightYDownZForward) {
  const CameraModel camera = Pinhole();
  EXPECT_TRUE(camera.Project({0.0, 0.0, 2.0})->isApprox(Vector2d(319.5, 239.5)));
  EXPECT_TRUE(camera.Project({0.5, 0.25, 2.0})->isApprox(Vector2d(319.5 + 80.0, 239.5 + 40.0)));
}

TEST(CameraModel, DistortsByTheTwoRadialTerms) {
  const CameraModel camera = WithDistortion(-0.2, 0.05);
  const Vector2d ideal(0.6, -0.8);
  EXPECT_TRUE(camera.Distort(ideal).isApprox(0.85 * ideal, 1e-15));
  EXPECT_TRUE(camera.Project({0.6, -0.8, 1.0})->isApprox(Vector2d(319.5 + 320.0 * 0.51, 239.5 - 320.0 * 0.68)));
}

TEST(CameraModel, DoesNotProjectPointsBehindTheCamera) {
  EXPECT_FALSE(CameraModel{}.Project({0.1, 0.1, -1.0}));
  EXPECT_FALSE(CameraModel{}.Project({0.1, 0.1, 0.0}));
}

TEST(CameraModel, DoesNotProjectBeyondTheMonotonicRadius) {
  const CameraModel camera = WithDistortion(-0.1, 0.0);
  const double r = camera.MonotonicRadius();
  EXPECT_NEAR(r, std::sqrt(1.0 / 0.3), 1e-12);
  EXPECT_TRUE(camera.Project({0.999 * r, 0.0, 1.0}));
  EXPECT_FALSE(camera.Project({1.001 * r, 0.0, 1.0}));
}

TEST(CameraModel, ComputesTheMonotonicRadius) {
  EXPECT_TRUE(std::isinf(Pinhole().MonotonicRadius()));
  EXPECT_TRUE(std::isinf(WithDistortion(0.1, 0.0).MonotonicRadius()));
  EXPECT_TRUE(std::isinf(WithDistortion(-0.283, 0.074).MonotonicRadius()));
  EXPECT_NEAR(WithDistortion(-0.1, 1e-18).MonotonicRadius(), std::sqrt(1.0 / 0.3), 1e-9);
  for (const auto& [k1, k2] : std::vector<std::pair<double, double>>{{-0.3, 0.01}, {0.2, -0.1}, {0.5, -0.32}}) {
    const CameraModel camera = WithDistortion(k1, k2);
    const double r = camera.MonotonicRadius();
    ASSERT_TRUE(std::isfinite(r)) << k1 << ", " << k2;
    const auto radius = [&](double ideal) { return camera.Distort({ideal, 0.0}).x(); };
    EXPECT_NEAR((radius(r + 1e-5) - radius(r - 1e-5)) / 2e-5, 0.0, 1e-6) << k1 << ", " << k2;
    for (double x = 0.01; x < r; x += 0.01) ASSERT_GT(radius(x), radius(x - 0.01));
  }
}

class DistortionRoundTrip : public ::testing::TestWithParam<std::pair<double, double>> {};

TEST_P(DistortionRoundTrip, IsExactOverTheWholeImage) {
  const CameraModel camera = WithDistortion(GetParam().first, GetParam().second);
  for (double u = -0.5; u <= 639.5; u += 10.0) {
    for (double v = -0.5; v <= 479.5; v += 10.0) {
      const auto ray = camera.Ray({u, v});
      ASSERT_TRUE(ray);
      ASSERT_NEAR(ray->norm(), 1.0, 1e-12);
      const auto back = camera.Project(3.0 * *ray);
      ASSERT_TRUE(back);
      ASSERT_LT((*back - Vector2d(u, v)).norm(), 1e-9) << u << ", " << v;
    }
  }
}

/// Radius whose distorted radius is `distorted`, by bisection below the monotonic radius.
double Bisect(const CameraModel& camera, double distorted) {
  double low = 0.0, high = std::min(camera.MonotonicRadius(), 1e3);
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (camera.Distort({middle, 0.0}).x() < distorted ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

TEST_P(DistortionRoundTrip, NewtonAgreesWithBisection) {
  const CameraModel camera = WithDistortion(GetParam().first, GetParam().second);
  const double corner = camera.NormalizedFromPixel({-0.5, -0.5}).norm();
  for (double distorted = 0.0; distorted <= corner; distorted += corner / 500.0) {
    const auto ideal = camera.Undistort({distorted, 0.0});
    ASSERT_TRUE(ideal);
    ASSERT_NEAR(ideal->x(), Bisect(camera, distorted), 1e-11);
  }
}

INSTANTIATE_TEST_SUITE_P(Lenses, DistortionRoundTrip,
                         ::testing::Values(std::pair(0.0, 0.0), std::pair(-0.10, 0.01), std::pair(-0.283, 0.074),
                                           std::pair(0.15, 0.02), std::pair(-0.09, 0.0), std::pair(0.3, -0.03)));

/// Typical calibrations of consumer cameras, including tangential and third radial terms.
std::vector<CameraModel> RealLenses() {
  CameraModel phone, wide, action;
  phone.fx_px = phone.fy_px = 520.0;
  phone.k1 = 0.12, phone.k2 = -0.25, phone.p1 = 8e-4, phone.p2 = -1.2e-3, phone.k3 = 0.25;
  wide.k1 = -0.283, wide.k2 = 0.074, wide.p1 = 1.9e-4, wide.p2 = 1.8e-5, wide.k3 = 0.0;
  action.k1 = -0.25, action.k2 = 0.09, action.p1 = -5e-4, action.p2 = 3e-4, action.k3 = -0.005;
  return {phone, wide, action};
}

TEST(CameraModel, DistortsByTangentialAndThirdRadialTerms) {
  CameraModel camera = WithDistortion(0.1, 0.2);
  camera.p1 = 0.01;
  camera.p2 = -0.02;
  camera.k3 = 0.3;
  // r^2 = 0.25, so the radial gain is 1 + 0.025 + 0.0125 + 0.0046875.
  const Vector2d ideal(0.3, -0.4);
  const Vector2d tangential(2 * 0.01 * -0.12 - 0.02 * (0.25 + 0.18), 0.01 * (0.25 + 0.32) + 2 * -0.02 * -0.12);
  EXPECT_TRUE(camera.Distort(ideal).isApprox(1.0421875 * ideal + tangential, 1e-14));
}

TEST(CameraModel, UndistortsRealLensesOverTheWholeImage) {
  for (const CameraModel& camera : RealLenses()) {
    ASSERT_NO_THROW(camera.Validate());
    for (double u = -0.5; u <= 639.5; u += 20.0) {
      for (double v = -0.5; v <= 479.5; v += 20.0) {
        const auto ray = camera.Ray({u, v});
        ASSERT_TRUE(ray) << camera.k1 << ": " << u << ", " << v;
        ASSERT_LT((*camera.Project(2.0 * *ray) - Vector2d(u, v)).norm(), 1e-8) << u << ", " << v;
      }
    }
  }
}

TEST(CameraModel, ComputesTheMonotonicRadiusWithAThirdRadialTerm) {
  for (const double k3 : {-0.02, -0.2, -1.0, 0.3}) {
    CameraModel camera = WithDistortion(-0.25, 0.09);
    camera.k3 = k3;
    const double r = camera.MonotonicRadius();
    const auto radius = [&](double ideal) { return camera.Distort({ideal, 0.0}).x(); };
    for (double x = 0.01; x < std::min(r, 5.0); x += 0.01) ASSERT_GT(radius(x), radius(x - 0.01)) << k3;
    EXPECT_EQ(std::isinf(r), k3 > 0.0);
    if (std::isfinite(r)) {
      EXPECT_NEAR((radius(r + 1e-5) - radius(r - 1e-5)) / 2e-5, 0.0, 1e-5) << k3;
    }
  }
}

TEST(CameraModel, UndistortReturnsNulloptBeyondTheMonotonicRange) {
  const CameraModel camera = WithDistortion(-0.1, 0.0);
  const double edge = camera.Distort({camera.MonotonicRadius(), 0.0}).x();
  EXPECT_TRUE(camera.Undistort({0.999 * edge, 0.0}));
  EXPECT_FALSE(camera.Undistort({1.001 * edge, 0.0}));
  EXPECT_EQ(*camera.Undistort({0.0, 0.0}), Vector2d::Zero());
}

TEST(CameraModel, ContainsPointsOnItsPixels) {
  const CameraModel camera;
  EXPECT_TRUE(camera.Contains({-0.5, -0.5}));
  EXPECT_TRUE(camera.Contains({639.5, 479.5}));
  EXPECT_FALSE(camera.Contains({-0.51, 10.0}));
  EXPECT_FALSE(camera.Contains({639.51, 10.0}));
  EXPECT_FALSE(camera.Contains({10.0, -0.51}));
  EXPECT_FALSE(camera.Contains({10.0, 479.51}));
}

TEST(CameraModelValidate, AcceptsValidCameras) {
  EXPECT_NO_THROW(CameraModel{}.Validate());
  EXPECT_NO_THROW(WithDistortion(-0.283, 0.074).Validate());
  EXPECT_NO_THROW((CameraModel{.width_px = 1, .height_px = 1, .cx_px = 0.0, .cy_px = 0.0}.Validate()));
}

TEST(CameraModelValidate, RejectsInvalidCameras) {
  const std::vector<std::function<void(CameraModel&)>> faults = {
      [](CameraModel& c) { c.width_px = 0; },
      [](CameraModel& c) { c.height_px = -480; },
      [](CameraModel& c) { c.width_px = 16385; },
      [](CameraModel& c) { c.height_px = 16385; },
      [](CameraModel& c) { c.fx_px = 0.0; },
      [](CameraModel& c) { c.fy_px = -320.0; },
      [](CameraModel& c) { c.fx_px = std::numeric_limits<double>::infinity(); },
      [](CameraModel& c) { c.cx_px = std::nan(""); },
      [](CameraModel& c) { c.cy_px = std::nan(""); },
      [](CameraModel& c) { c.k1 = std::nan(""); },
      [](CameraModel& c) { c.k2 = -std::numeric_limits<double>::infinity(); },
      [](CameraModel& c) { c.k1 = -0.4; },
      [](CameraModel& c) { c.p1 = std::nan(""); },
      [](CameraModel& c) { c.p2 = 1.0; },
      [](CameraModel& c) { c.k3 = -0.5; },
  };
  for (std::size_t i = 0; i < faults.size(); ++i) {
    CameraModel camera;
    faults[i](camera);
    EXPECT_THROW(camera.Validate(), InputError) << "fault " << i;
  }
}

}  // namespace
}  // namespace touchdown::models
