#include "estimator/pad/letter_outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace touchdown::estimator::pad {
namespace {

using Eigen::Vector2d;

TEST(LetterOutline, LiesBetweenTheHsBlackAndWhite) {
  const models::LandingPad pad;
  constexpr double kStep_m = 1e-6;
  const auto outline = LetterOutline(pad, 0.001);
  EXPECT_GT(outline.size(), 400u);
  for (const Vector2d& p : outline) {
    const int black = pad.IsLetter(p + Vector2d(kStep_m, kStep_m)) + pad.IsLetter(p + Vector2d(-kStep_m, kStep_m)) +
                      pad.IsLetter(p + Vector2d(kStep_m, -kStep_m)) + pad.IsLetter(p + Vector2d(-kStep_m, -kStep_m));
    EXPECT_EQ(black, 2) << p.transpose();
    EXPECT_LT(DistanceFromLetter(pad, p), 1e-12);
  }
}

TEST(LetterOutline, IsAsLongAsTheHIsRound) {
  const models::LandingPad pad;
  constexpr double kSpacing_m = 0.0005;
  const double length = 4.0 * pad.h_height_m + 2.0 * pad.h_width_m - 2.0 * pad.h_stroke_m;
  EXPECT_NEAR(static_cast<double>(LetterOutline(pad, kSpacing_m).size()) * kSpacing_m, length, 0.02 * length);
}

TEST(LetterOutline, OfARectangleIsItsFourSides) {
  models::LandingPad pad;
  pad.h_stroke_m = 0.5 * pad.h_width_m;
  constexpr double kSpacing_m = 0.0005;
  const double x = pad.h_height_m / 2.0, y = pad.h_width_m / 2.0;
  const auto outline = LetterOutline(pad, kSpacing_m);
  for (const Vector2d& p : outline) {
    EXPECT_NEAR(std::max(std::abs(p.x()) - x, std::abs(p.y()) - y), 0.0, 1e-12) << p.transpose();
    EXPECT_LT(DistanceFromLetter(pad, p), 1e-12);
  }
  EXPECT_NEAR(static_cast<double>(outline.size()) * kSpacing_m, 4.0 * (x + y), 0.01);
  EXPECT_NEAR(DistanceFromLetter(pad, {0.0, 0.0}), y, 1e-12) << "in its middle there is no edge";
  EXPECT_NEAR(DistanceFromLetter(pad, {x + 0.003, y + 0.004}), 0.005, 1e-12);
}

TEST(LetterOutline, TellsHowFarAPointIsFromIt) {
  const models::LandingPad pad;
  const double x = pad.h_height_m / 2.0, y = pad.h_width_m / 2.0;
  EXPECT_NEAR(DistanceFromLetter(pad, {0.01, y + 0.02}), 0.02, 1e-12);
  EXPECT_NEAR(DistanceFromLetter(pad, {-x - 0.003, -y - 0.004}), 0.005, 1e-12) << "off a corner";
  EXPECT_NEAR(DistanceFromLetter(pad, {0.0, 0.0}), pad.h_stroke_m / 2.0, 1e-12) << "in the bar's middle";
  EXPECT_NEAR(DistanceFromLetter(pad, {0.03, 0.0}), y - pad.h_stroke_m, 1e-12) << "between the strokes";
}

}  // namespace
}  // namespace touchdown::estimator::pad
