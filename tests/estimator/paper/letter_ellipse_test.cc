#include "estimator/paper/letter_ellipse.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/angles.h"
#include "models/error.h"
#include "tests/support/synthetic_pad.h"

namespace touchdown::estimator::paper {
namespace {

TEST(LetterEllipse, TakesTheMajorAxisForTheStrokesOfAHighH) {
  const LetterEllipse letter{models::LandingPad()};
  EXPECT_DOUBLE_EQ(letter.StrokeAngle({{0.0, 0.0}, {2.0, 1.0}, 0.3}), 0.3);
}

TEST(LetterEllipse, TakesTheMinorAxisForTheStrokesOfAWideH) {
  models::LandingPad pad;
  pad.h_height_m = 0.050;
  pad.h_width_m = 0.110;
  pad.Validate();
  const LetterEllipse letter{pad};
  EXPECT_NEAR(letter.StrokeAngle({{0.0, 0.0}, {2.0, 1.0}, 0.3}), 0.3 - models::kPi / 2.0, 1e-12);
}

TEST(LetterEllipse, SeesTheStrokesStraightFromAbove) {
  const LetterEllipse letter{models::LandingPad()};
  for (const double yaw : {-1.2, -0.3, 0.0, 0.8}) {
    for (const double x : {0.0, 0.4}) {
      const auto angle = letter.StrokeAngleSeenFrom(tests::CameraAbovePad({x, 0.2, 1.0}, yaw).inverse());
      ASSERT_TRUE(angle);
      // Turning left by yaw turns the strokes to the image's right, from straight up.
      EXPECT_NEAR(models::WrapToHalfPi(*angle - (yaw - models::kPi / 2.0)), 0.0, 1e-6);
    }
  }
}

TEST(LetterEllipse, OfARectangleLiesAlongItsLongSide) {
  models::LandingPad pad;
  pad.h_stroke_m = 0.5 * pad.h_width_m;
  const LetterEllipse letter{pad};
  EXPECT_TRUE(letter.HasDirection());
  EXPECT_DOUBLE_EQ(letter.StrokeAngle({{0.0, 0.0}, {2.0, 1.0}, 0.3}), 0.3);
  for (const double yaw : {-1.2, -0.3, 0.0, 0.8}) {
    const auto angle = letter.StrokeAngleSeenFrom(tests::CameraAbovePad({0.3, 0.2, 1.0}, yaw).inverse());
    ASSERT_TRUE(angle);
    EXPECT_NEAR(models::WrapToHalfPi(*angle - (yaw - models::kPi / 2.0)), 0.0, 1e-6);
  }
}

TEST(LetterEllipse, IsTurnedByPerspectiveWhenSeenFromAside) {
  const LetterEllipse letter{models::LandingPad()};
  // Tilted about the image's up, which lies at 45 degrees to the strokes.
  const double yaw = models::DegToRad(45.0);
  const auto turned_at = [&](double tilt) {
    auto X_WC = tests::CameraAbovePad(Eigen::Vector3d::Zero(), yaw, tilt, yaw);
    X_WC.translation() = -X_WC.linear().col(2);
    return models::WrapToHalfPi(*letter.StrokeAngleSeenFrom(X_WC.inverse()) - (yaw - models::kPi / 2.0));
  };
  EXPECT_LT(std::abs(turned_at(models::DegToRad(2.0))), models::DegToRad(0.2));
  EXPECT_GT(std::abs(turned_at(models::DegToRad(40.0))), models::DegToRad(5.0));
}

TEST(LetterEllipse, HasNoDirectionBetweenAHighAndAWideH) {
  models::LandingPad pad;
  pad.h_height_m = 0.070;
  pad.h_stroke_m = 0.012;
  int without = 0, with = 0;
  for (pad.h_width_m = 0.040; pad.h_width_m < 0.110; pad.h_width_m += 0.001) {
    const LetterEllipse letter(pad);
    ++(letter.HasDirection() ? with : without);
    const auto angle = letter.StrokeAngleSeenFrom(tests::CameraAbovePad({0.0, 0.0, 1.0}, 0.3).inverse());
    ASSERT_TRUE(angle);
    EXPECT_NEAR(models::WrapToHalfPi(*angle - (0.3 - models::kPi / 2.0)), 0.0, 1e-6);
  }
  EXPECT_GT(without, 3);
  EXPECT_GT(with, 20);
}

TEST(LetterEllipse, RefusesAnImpossiblePad) {
  models::LandingPad pad;
  pad.h_height_m = 0.5;
  EXPECT_THROW(LetterEllipse{pad}, InputError);
}

}  // namespace
}  // namespace touchdown::estimator::paper
