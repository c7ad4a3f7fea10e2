#include "estimator/pad/ellipse_detection.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/angles.h"
#include "models/error.h"
#include "tests/support/synthetic_pad.h"

namespace touchdown::estimator::pad {
namespace {

using Eigen::Vector2d;

class EllipseDetectionTest : public testing::Test {
 protected:
  EllipseDetectionTest() { camera_.k1 = camera_.k2 = 0.0; }

  std::vector<Ellipse> Detect(const tests::PadAppearance& appearance) const {
    return DetectEllipses(tests::RenderPad(camera_, pad_, X_WC_, appearance).View());
  }

  /// Largest distance from an ellipse to the points of the ring's outer boundary, px.
  double MaxDistance(const Ellipse& ellipse) const {
    double max_distance = 0.0;
    for (int i = 0; i < 90; ++i) {
      const double angle = 2.0 * models::kPi * i / 90;
      const Eigen::Vector3d p_W = pad_.outer_radius_m * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
      max_distance = std::max(max_distance, std::abs(DistanceFrom(ellipse, *camera_.Project(X_WC_.inverse() * p_W))));
    }
    return max_distance;
  }

  models::CameraModel camera_;
  models::LandingPad pad_;
  Eigen::Isometry3d X_WC_ = tests::CameraAbovePad({0.05, 0.03, 0.5}, 0.3, models::DegToRad(25.0), 0.5);
};

TEST_F(EllipseDetectionTest, FindsTheRingsOuterBoundaryFirst) {
  const auto rings = Detect({.noise_sigma = 0.0});
  ASSERT_FALSE(rings.empty());
  EXPECT_LT(MaxDistance(rings.front()), 1.0);
}

TEST_F(EllipseDetectionTest, FindsAnInterruptedRing) {
  // A third of the ring is overexposed.
  const auto glare = [](const Vector2d& p) -> std::optional<double> {
    const double angle = std::atan2(p.y(), p.x());
    return p.norm() < 0.1 && std::abs(std::remainder(angle, models::kPi)) < 0.5 ? std::optional(215.0) : std::nullopt;
  };
  const auto rings = Detect({.paint = glare});
  ASSERT_FALSE(rings.empty());
  EXPECT_LT(MaxDistance(rings.front()), 1.5);
}

TEST_F(EllipseDetectionTest, IgnoresRingsWithTooLittleCoverage) {
  const auto half = [](const Vector2d& p) -> std::optional<double> {
    return p.x() > 0.0 ? std::optional(215.0) : std::nullopt;
  };
  for (const Ellipse& ring : Detect({.paint = half})) EXPECT_GT(MaxDistance(ring), 5.0);
}

TEST_F(EllipseDetectionTest, IgnoresABrightDiscAndASquare) {
  const auto disc = [](const Vector2d& p) { return std::optional(p.norm() < 0.09 ? 215.0 : 60.0); };
  const auto square = [](const Vector2d& p) {
    const double side = p.cwiseAbs().maxCoeff();
    return std::optional(side > 0.074 && side < 0.09 ? 25.0 : 215.0);
  };
  EXPECT_TRUE(Detect({.paint = disc}).empty());
  EXPECT_TRUE(Detect({.paint = square}).empty());
}

TEST_F(EllipseDetectionTest, IgnoresARingThatLeavesTheImage) {
  X_WC_ = tests::CameraAbovePad({0.0, 0.45, 0.5});
  ASSERT_TRUE(camera_.Contains(*camera_.Project(X_WC_.inverse() * Eigen::Vector3d::Zero())));
  ASSERT_FALSE(camera_.Contains(*camera_.Project(X_WC_.inverse() * Eigen::Vector3d(0.0, -0.09, 0.0))));
  for (const Ellipse& ring : Detect({})) EXPECT_GT(MaxDistance(ring), 5.0);
}

TEST_F(EllipseDetectionTest, FindsNothingInTinyImages) {
  models::RandomStream random(1, "pixels");
  for (int width = 1; width < 8; ++width) {
    for (int height = 1; height < 8; ++height) {
      models::Image image(width, height);
      for (auto& pixel : image.pixels) pixel = static_cast<std::uint8_t>(random.UniformInt(0, 255));
      EXPECT_TRUE(DetectEllipses(image.View()).empty());
    }
  }
}

TEST_F(EllipseDetectionTest, RejectsInvalidSettings) {
  EXPECT_THROW((EllipseDetectionConfig{.canny_low = 50.0, .canny_high = 40.0}.Validate()), InputError);
  EXPECT_THROW((EllipseDetectionConfig{.min_coverage = 1.1}.Validate()), InputError);
  EXPECT_THROW((EllipseDetectionConfig{.min_semi_axis_px = 0.0}.Validate()), InputError);
  EXPECT_THROW((EllipseDetectionConfig{.min_axis_ratio = 2.0}.Validate()), InputError);
  EXPECT_THROW((EllipseDetectionConfig{.max_rings = 0}.Validate()), InputError);
}

}  // namespace
}  // namespace touchdown::estimator::pad
