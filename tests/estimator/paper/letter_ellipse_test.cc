#include "estimator/paper/letter_ellipse.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/angles.h"
#include "models/error.h"
#include "tests/support/synthetic_pad.h"

namespace touchdown::estimator::paper {
namespace {

TEST(LetterEllipse, UsesTheMajorAxisForAHighH) {
  const LetterEllipse letter{models::LandingPad()};
  EXPECT_DOUBLE_EQ(letter.StrokeAngle({{0.0, 0.0}, {2.0, 1.0}, 0.3}), 0.3);
}

TEST(LetterEllipse, UsesTheMinorAxisForAWideH) {
  models::LandingPad pad;
  pad.h_height_m = 0.050;
  pad.h_width_m = 0.110;
  pad.Validate();
  const LetterEllipse letter{pad};
  EXPECT_NEAR(letter.StrokeAngle({{0.0, 0.0}, {2.0, 1.0}, 0.3}), 0.3 - models::kPi / 2.0, 1e-12);
}

TEST(LetterEllipse, ProjectsTheStrokesWithoutErrorFromAbove) {
  const LetterEllipse letter{models::LandingPad()};
  for (const double yaw : {-1.2, -0.3, 0.0, 0.8}) {
    for (const double x : {0.0, 0.4}) {
      const auto angle = letter.ProjectedStrokeAngle(tests::CameraAbovePad({x, 0.2, 1.0}, yaw).inverse());
      ASSERT_TRUE(angle);
      // At yaw 0 the strokes point up in the image. A rotation of the camera to the left rotates them to the right.
      EXPECT_NEAR(models::WrapToHalfPi(*angle - (yaw - models::kPi / 2.0)), 0.0, 1e-6);
    }
  }
}

TEST(LetterEllipse, HasTheDirectionOfTheLongSideOfARectangle) {
  models::LandingPad pad;
  pad.h_stroke_m = 0.5 * pad.h_width_m;
  const LetterEllipse letter{pad};
  EXPECT_TRUE(letter.HasDirection());
  EXPECT_DOUBLE_EQ(letter.StrokeAngle({{0.0, 0.0}, {2.0, 1.0}, 0.3}), 0.3);
  for (const double yaw : {-1.2, -0.3, 0.0, 0.8}) {
    const auto angle = letter.ProjectedStrokeAngle(tests::CameraAbovePad({0.3, 0.2, 1.0}, yaw).inverse());
    ASSERT_TRUE(angle);
    EXPECT_NEAR(models::WrapToHalfPi(*angle - (yaw - models::kPi / 2.0)), 0.0, 1e-6);
  }
}

TEST(LetterEllipse, IsRotatedByPerspectiveInObliqueViews) {
  const LetterEllipse letter{models::LandingPad()};
  // The tilt axis is the image's up direction, at 45 degrees to the strokes.
  const double yaw = models::DegToRad(45.0);
  const auto rotation_at = [&](double tilt) {
    auto X_WC = tests::CameraAbovePad(Eigen::Vector3d::Zero(), yaw, tilt, yaw);
    X_WC.translation() = -X_WC.linear().col(2);
    return models::WrapToHalfPi(*letter.ProjectedStrokeAngle(X_WC.inverse()) - (yaw - models::kPi / 2.0));
  };
  EXPECT_LT(std::abs(rotation_at(models::DegToRad(2.0))), models::DegToRad(0.2));
  EXPECT_GT(std::abs(rotation_at(models::DegToRad(40.0))), models::DegToRad(5.0));
}

TEST(LetterEllipse, HasNoDirectionForANearlySquareH) {
  models::LandingPad pad;
  pad.h_height_m = 0.070;
  pad.h_stroke_m = 0.012;
  int without = 0, with = 0;
  for (pad.h_width_m = 0.040; pad.h_width_m < 0.110; pad.h_width_m += 0.001) {
    const LetterEllipse letter(pad);
    ++(letter.HasDirection() ? with : without);
    const auto angle = letter.ProjectedStrokeAngle(tests::CameraAbovePad({0.0, 0.0, 1.0}, 0.3).inverse());
    ASSERT_TRUE(angle);
    EXPECT_NEAR(models::WrapToHalfPi(*angle - (0.3 - models::kPi / 2.0)), 0.0, 1e-6);
  }
  EXPECT_GT(without, 3);
  EXPECT_GT(with, 20);
}

TEST(LetterEllipse, RejectsAnInvalidPad) {
  models::LandingPad pad;
  pad.h_height_m = 0.5;
  EXPECT_THROW(LetterEllipse{pad}, InputError);
}

}  // namespace
}  // namespace touchdown::estimator::paper
