#include "models/pad_outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "models/angles.h"

namespace touchdown::models {
namespace {

using Eigen::Vector2d;

LandingPad PadWithRectangle() {
  LandingPad pad;
  pad.h_stroke_m = 0.5 * pad.h_width_m;
  return pad;
}

/// Pad with a disc next to the H, a bar over the end of one of its strokes and a rotated bar.
LandingPad PadWithMarkings() {
  LandingPad pad;
  pad.marks = {{.shape = PadMarking::Shape::kDisc, .center_m = {0.02, 0.05}, .diameter_m = 0.01},
               {.shape = PadMarking::Shape::kBar, .center_m = {0.05, 0.02}, .length_m = 0.03, .width_m = 0.004},
               {.shape = PadMarking::Shape::kBar,
                .center_m = {-0.02, 0.05},
                .length_m = 0.02,
                .width_m = 0.004,
                .angle_deg = 30.0}};
  pad.Validate();
  return pad;
}

double SignedArea(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.corners_m.size(); ++i) {
    const Vector2d a = polygon.corners_m[i], b = polygon.corners_m[(i + 1) % polygon.corners_m.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

TEST(PadOutline, IsBlackOnTheWholeRing) {
  const LandingPad pad;
  const PadOutline outline(pad);
  for (double angle = 0.0; angle < 2.0 * kPi; angle += 0.1) {
    const Vector2d direction(std::cos(angle), std::sin(angle));
    EXPECT_FALSE(outline.IsBlack((pad.inner_radius_m() - 1e-6) * direction));
    EXPECT_TRUE(outline.IsBlack((pad.inner_radius_m() + 1e-6) * direction));
    EXPECT_TRUE(outline.IsBlack((pad.outer_radius_m - 1e-6) * direction));
    EXPECT_FALSE(outline.IsBlack((pad.outer_radius_m + 1e-6) * direction));
  }
}

TEST(PadOutline, HasTheLongStrokesOfTheHAlongX) {
  const LandingPad pad;
  const PadOutline outline(pad);
  const double stroke_y = (pad.h_width_m - pad.h_stroke_m) / 2.0;
  for (const double side : {-1.0, 1.0}) {
    EXPECT_TRUE(outline.IsBlack({pad.h_height_m / 2.0 - 1e-6, side * stroke_y}));
    EXPECT_TRUE(outline.IsBlack({-pad.h_height_m / 2.0 + 1e-6, side * stroke_y}));
    EXPECT_FALSE(outline.IsBlack({pad.h_height_m / 2.0 + 1e-6, side * stroke_y}));
  }
  EXPECT_TRUE(outline.IsBlack({0.0, 0.0})) << "the cross-bar";
  EXPECT_FALSE(outline.IsBlack({pad.h_stroke_m / 2.0 + 1e-6, 0.0})) << "white between the strokes";
  EXPECT_FALSE(outline.IsBlack({0.0, pad.h_width_m / 2.0 + 1e-6})) << "white beside the H";
}

TEST(PadOutline, IsBlackOnEveryBorder) {
  const LandingPad pad;
  const PadOutline outline(pad);
  const double x = pad.h_height_m / 2.0, y = pad.h_width_m / 2.0, bar_x = pad.h_stroke_m / 2.0;
  for (const Vector2d& mirror : {Vector2d(1, 1), Vector2d(-1, 1), Vector2d(-1, -1), Vector2d(1, -1)}) {
    for (const Vector2d& p : {Vector2d(x, y), Vector2d(x, y - pad.h_stroke_m), Vector2d(bar_x, y - pad.h_stroke_m),
                              Vector2d(0.01, y), Vector2d(x, 0.02), Vector2d(bar_x, 0.001),
                              Vector2d(pad.inner_radius_m(), 0.0), Vector2d(0.0, pad.outer_radius_m)}) {
      EXPECT_TRUE(outline.IsBlack(p.cwiseProduct(mirror))) << p.cwiseProduct(mirror).transpose();
    }
  }
}

TEST(PadOutline, IsSymmetricUnderHalfATurn) {
  const PadOutline outline({});
  for (double x = -0.1; x <= 0.1; x += 0.0037) {
    for (double y = -0.1; y <= 0.1; y += 0.0037) {
      EXPECT_EQ(outline.IsBlack({x, y}), outline.IsBlack({-x, -y}));
      EXPECT_EQ(outline.IsBlack({x, y}), outline.IsBlack({x, -y}));
    }
  }
}

TEST(PadOutline, HasTheBlackAreaOfRingAndH) {
  const PadOutline outline({});
  constexpr double kStep_m = 0.0005;
  double black = 0.0;
  for (double x = -0.1 + kStep_m / 2.0; x < 0.1; x += kStep_m) {
    for (double y = -0.1 + kStep_m / 2.0; y < 0.1; y += kStep_m) {
      if (outline.IsBlack({x, y})) black += kStep_m * kStep_m;
    }
  }
  const double ring = kPi * (0.090 * 0.090 - 0.074 * 0.074);
  const double letter = 2.0 * 0.100 * 0.016 + (0.056 - 2.0 * 0.016) * 0.016;
  EXPECT_NEAR(black, ring + letter, 0.01 * (ring + letter));
}

TEST(PadOutline, IsBlackOnMarkings) {
  const PadOutline marked(PadWithMarkings()), plain({});
  const Vector2d along(std::cos(DegToRad(30.0)), 0.5), across(-0.5, std::cos(DegToRad(30.0)));
  for (double x = -0.1; x <= 0.1; x += 0.0007) {
    for (double y = -0.1; y <= 0.1; y += 0.0007) {
      const Vector2d p(x, y), from_bar = p - Vector2d(-0.02, 0.05);
      const bool on_mark = (p - Vector2d(0.02, 0.05)).norm() <= 0.005 ||
                           (std::abs(x - 0.05) <= 0.015 && std::abs(y - 0.02) <= 0.002) ||
                           (std::abs(from_bar.dot(along)) <= 0.01 && std::abs(from_bar.dot(across)) <= 0.002);
      EXPECT_EQ(marked.IsBlack(p), plain.IsBlack(p) || on_mark) << p.transpose();
    }
  }
}

TEST(PadOutline, SeparatesTheLetterFromRingAndMarkings) {
  const PadOutline marked(PadWithMarkings()), plain({});
  EXPECT_TRUE(marked.IsLetter({0.0, 0.0}));
  EXPECT_TRUE(marked.IsLetter({0.049, 0.02})) << "under the bar";
  EXPECT_FALSE(marked.IsLetter({0.051, 0.02})) << "on the bar alone";
  EXPECT_FALSE(marked.IsLetter({0.02, 0.05})) << "on the disc";
  EXPECT_FALSE(marked.IsLetter({0.08, 0.0})) << "on the ring";
  for (double x = -0.05; x <= 0.05; x += 0.0037) {
    for (double y = -0.05; y <= 0.05; y += 0.0037) EXPECT_EQ(marked.IsLetter({x, y}), plain.IsBlack({x, y}));
  }
}

TEST(PadOutline, HasOneRectangleWhenTheStrokesMeet) {
  const PadOutline outline(PadWithRectangle());
  for (double x = -0.06; x <= 0.06; x += 0.0005) {
    for (double y = -0.06; y <= 0.06; y += 0.0005) {
      EXPECT_EQ(outline.IsLetter({x, y}), std::abs(x) <= 0.050 && std::abs(y) <= 0.028) << x << " " << y;
    }
  }
  EXPECT_TRUE(outline.IsLetter({0.049, 0.0})) << "where the strokes meet";
}

TEST(PadOutline, HasARectangleWhenTheStrokesMeetUpToRounding) {
  LandingPad pad;
  for (int i = 1; i < 2000; ++i) {
    pad.h_width_m = 1e-5 * i * 3.1;
    for (const double half : {pad.h_width_m / 2.0, pad.h_width_m * 0.1 * 5.0, pad.h_width_m / 3.0 * 1.5}) {
      pad.h_stroke_m = half;
      EXPECT_TRUE(PadOutline(pad).IsLetter({0.049, 0.0}));
    }
  }
}

TEST(PadOutline, ListsItsShapesInPrintingOrder) {
  const LandingPad pad = PadWithMarkings();
  const PadOutline outline(pad);
  const auto& shapes = outline.shapes();
  ASSERT_EQ(shapes.size(), 4u + pad.marks.size());
  using Color = PadShape::Color;
  EXPECT_EQ(shapes[0].color, Color::kWhite);
  EXPECT_NEAR(SignedArea(std::get<Polygon>(shapes[0].outline)), pad.sheet_length_m * pad.sheet_width_m, 1e-12);
  EXPECT_EQ(shapes[1].color, Color::kBlack);
  EXPECT_EQ(std::get<Circle>(shapes[1].outline).radius_m, pad.outer_radius_m);
  EXPECT_EQ(shapes[2].color, Color::kWhite);
  EXPECT_EQ(std::get<Circle>(shapes[2].outline).radius_m, pad.inner_radius_m());
  for (std::size_t i = 3; i < shapes.size(); ++i) EXPECT_EQ(shapes[i].color, Color::kBlack);
}

TEST(PadOutline, ListsTheLettersCornersCounterClockwise) {
  const LandingPad pad;
  const double area = 2.0 * pad.h_height_m * pad.h_stroke_m + (pad.h_width_m - 2.0 * pad.h_stroke_m) * pad.h_stroke_m;
  EXPECT_EQ(PadOutline(pad).letter().corners_m.size(), 12u);
  EXPECT_NEAR(SignedArea(PadOutline(pad).letter()), area, 1e-12);
  const LandingPad solid = PadWithRectangle();
  EXPECT_EQ(PadOutline(solid).letter().corners_m.size(), 4u);
  EXPECT_NEAR(SignedArea(PadOutline(solid).letter()), solid.h_height_m * solid.h_width_m, 1e-12);
}

TEST(PadOutline, PutsPointsOnTheBorderBetweenBlackAndWhite) {
  const PadOutline outline({});
  constexpr double kStep_m = 1e-6;
  const auto points = outline.PointsAlongLetter(0.001);
  EXPECT_GT(points.size(), 400u);
  for (const Vector2d& p : points) {
    const int black =
        outline.IsLetter(p + Vector2d(kStep_m, kStep_m)) + outline.IsLetter(p + Vector2d(-kStep_m, kStep_m)) +
        outline.IsLetter(p + Vector2d(kStep_m, -kStep_m)) + outline.IsLetter(p + Vector2d(-kStep_m, -kStep_m));
    EXPECT_EQ(black, 2) << p.transpose();
    EXPECT_LT(outline.DistanceFromLetter(p), 1e-12);
  }
}

TEST(PadOutline, PutsPointsSymmetricallyAboutBothAxes) {
  for (const LandingPad& pad : {LandingPad(), PadWithRectangle()}) {
    const auto points = PadOutline(pad).PointsAlongLetter(0.001);
    for (const Vector2d& p : points) {
      EXPECT_NE(std::find(points.begin(), points.end(), Vector2d(-p.x(), p.y())), points.end()) << p.transpose();
      EXPECT_NE(std::find(points.begin(), points.end(), Vector2d(p.x(), -p.y())), points.end()) << p.transpose();
    }
  }
}

TEST(PadOutline, PutsPointsAroundTheWholeH) {
  const LandingPad pad;
  constexpr double kSpacing_m = 0.0005;
  const double length = 4.0 * pad.h_height_m + 2.0 * pad.h_width_m - 2.0 * pad.h_stroke_m;
  const auto count = static_cast<double>(PadOutline(pad).PointsAlongLetter(kSpacing_m).size());
  EXPECT_NEAR(count * kSpacing_m, length, 0.02 * length);
}

TEST(PadOutline, PutsPointsOnTheFourSidesOfARectangle) {
  const LandingPad pad = PadWithRectangle();
  const PadOutline outline(pad);
  constexpr double kSpacing_m = 0.0005;
  const double x = pad.h_height_m / 2.0, y = pad.h_width_m / 2.0;
  const auto points = outline.PointsAlongLetter(kSpacing_m);
  for (const Vector2d& p : points) {
    EXPECT_NEAR(std::max(std::abs(p.x()) - x, std::abs(p.y()) - y), 0.0, 1e-12) << p.transpose();
    EXPECT_LT(outline.DistanceFromLetter(p), 1e-12);
  }
  EXPECT_NEAR(static_cast<double>(points.size()) * kSpacing_m, 4.0 * (x + y), 0.01);
}

TEST(PadOutline, MeasuresTheDistanceOfAPointFromTheLetter) {
  const LandingPad pad;
  const double x = pad.h_height_m / 2.0, y = pad.h_width_m / 2.0;
  const PadOutline outline(pad);
  EXPECT_NEAR(outline.DistanceFromLetter({0.01, y + 0.02}), 0.02, 1e-12);
  EXPECT_NEAR(outline.DistanceFromLetter({-x - 0.003, -y - 0.004}), 0.005, 1e-12) << "off a corner";
  EXPECT_NEAR(outline.DistanceFromLetter({0.0, 0.0}), pad.h_stroke_m / 2.0, 1e-12) << "in the bar's middle";
  EXPECT_NEAR(outline.DistanceFromLetter({0.03, 0.0}), y - pad.h_stroke_m, 1e-12) << "between the strokes";
  const PadOutline solid(PadWithRectangle());
  EXPECT_NEAR(solid.DistanceFromLetter({0.0, 0.0}), y, 1e-12) << "center of a rectangle";
  EXPECT_NEAR(solid.DistanceFromLetter({x + 0.003, y + 0.004}), 0.005, 1e-12);
}

TEST(PadOutline, FindsTheNarrowestStripe) {
  const auto narrowest = [](auto change) {
    LandingPad pad;
    pad.sheet_width_m = 0.25;
    change(pad);
    pad.Validate();
    return PadOutline(pad).narrowest_m();
  };
  EXPECT_NEAR(PadOutline({}).narrowest_m(), 0.015, 1e-12) << "between ring and sheet's border";
  EXPECT_NEAR(narrowest([](LandingPad&) {}), 0.016, 1e-12) << "ring and strokes";
  EXPECT_NEAR(narrowest([](LandingPad& p) { p.ring_width_m = 0.004; }), 0.004, 1e-12) << "the ring";
  EXPECT_NEAR(narrowest([](LandingPad& p) { p.h_stroke_m = 0.005; }), 0.005, 1e-12) << "a stroke";
  EXPECT_NEAR(narrowest([](LandingPad& p) { p.h_stroke_m = 0.026; }), 0.004, 1e-12) << "between the strokes";
  EXPECT_NEAR(narrowest([](LandingPad& p) { p.h_height_m = 0.030; }), 0.007, 1e-12) << "beside the bar";
  EXPECT_NEAR(narrowest([](LandingPad& p) { p.h_height_m = 0.120; }), 0.074 - std::hypot(0.060, 0.028), 1e-12)
      << "between ring and letter";
  EXPECT_NEAR(narrowest([](LandingPad& p) {
                p.h_width_m = 0.012;
                p.h_stroke_m = 0.006;
              }),
              0.012, 1e-12)
      << "a solid rectangle";
  EXPECT_NEAR(narrowest([](LandingPad& p) { p.marks = PadWithMarkings().marks; }), 0.016, 1e-12)
      << "markings are ignored";
}

}  // namespace
}  // namespace touchdown::models
