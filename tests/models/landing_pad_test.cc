#include "models/landing_pad.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "models/angles.h"
#include "models/error.h"

namespace touchdown::models {
namespace {

TEST(LandingPad, HasAnA4SheetAndA90MillimeterRingByDefault) {
  const LandingPad pad;
  EXPECT_NO_THROW(pad.Validate());
  EXPECT_EQ(pad.outer_radius_m, 0.090);
  EXPECT_EQ(pad.sheet_length_m, 0.297);
  EXPECT_EQ(pad.sheet_width_m, 0.210);
}

/// Pad with a disc next to the H and a bar over the end of one of its strokes.
LandingPad MarkedPad() {
  LandingPad pad;
  pad.marks = {{.shape = PadMarking::Shape::kDisc, .center_m = {0.02, 0.05}, .diameter_m = 0.01},
               {.shape = PadMarking::Shape::kBar, .center_m = {0.05, 0.02}, .length_m = 0.03, .width_m = 0.004}};
  return pad;
}

TEST(LandingPad, HasARectangleWhenItsStrokesMeet) {
  EXPECT_EQ(LandingPad().letter(), PadLetter::kH);
  LandingPad pad;
  pad.h_stroke_m = 0.028;
  EXPECT_NO_THROW(pad.Validate());
  EXPECT_EQ(pad.letter(), PadLetter::kRectangle);
}

TEST(LandingPad, HasARectangleWhenHalfItsWidthIsRounded) {
  for (int i = 1; i < 2000; ++i) {
    LandingPad pad;
    pad.h_width_m = 1e-5 * i * 3.1;
    for (const double half : {pad.h_width_m / 2.0, pad.h_width_m * 0.1 * 5.0, pad.h_width_m / 3.0 * 1.5}) {
      pad.h_stroke_m = half;
      EXPECT_EQ(pad.letter(), PadLetter::kRectangle);
      EXPECT_NO_THROW(pad.Validate());
    }
    pad.h_stroke_m = 0.5 * (pad.h_width_m - 1e-6);
    EXPECT_EQ(pad.letter(), PadLetter::kH) << "strokes 1 micrometer apart";
  }
}

TEST(LandingPadValidate, RejectsAMarkingOutsideItsRing) {
  LandingPad pad = MarkedPad();
  pad.marks[0].center_m = {0.0, 0.069};
  EXPECT_THROW(pad.Validate(), InputError);
  pad = MarkedPad();
  pad.ring_width_m = 0.022;
  EXPECT_THROW(pad.Validate(), InputError) << "the wider ring covers the end of the bar";
  pad.marks.clear();
  EXPECT_NO_THROW(pad.Validate());
}

TEST(LandingPadValidate, RejectsImpossibleDimensions) {
  const std::vector<std::function<void(LandingPad&)>> faults = {
      [](LandingPad& p) { p.outer_radius_m = 0.0; },
      [](LandingPad& p) { p.ring_width_m = -0.01; },
      [](LandingPad& p) { p.ring_width_m = 0.09; },
      [](LandingPad& p) { p.h_height_m = std::nan(""); },
      [](LandingPad& p) { p.h_width_m = std::numeric_limits<double>::infinity(); },
      [](LandingPad& p) { p.h_stroke_m = 0.0; },
      [](LandingPad& p) { p.h_stroke_m = 0.029; },
      [](LandingPad& p) { p.h_height_m = 0.015; },
      [](LandingPad& p) { p.h_height_m = 0.140; },
      [](LandingPad& p) { p.sheet_length_m = 0.1; },
      [](LandingPad& p) { p.sheet_width_m = 0.179; },
  };
  for (std::size_t i = 0; i < faults.size(); ++i) {
    LandingPad pad;
    faults[i](pad);
    EXPECT_THROW(pad.Validate(), InputError) << "fault " << i;
  }
}

TEST(ResolveYawAmbiguity, RotatesThePoseBy180DegreesWhenThatYawIsNearer) {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.translation() << 0.3, -0.2, 1.0;
  X_WB.linear() = RotationFromTaitBryan({0.1, -0.05, DegToRad(80)});
  EXPECT_TRUE(ResolveYawAmbiguity(X_WB, DegToRad(20)).isApprox(X_WB));
  const Eigen::Isometry3d resolved = ResolveYawAmbiguity(X_WB, DegToRad(-95));
  EXPECT_TRUE(resolved.translation().isApprox(Eigen::Vector3d(-0.3, 0.2, 1.0)));
  const TaitBryan angles = TaitBryanFromRotation(resolved.linear());
  EXPECT_NEAR(angles.roll, 0.1, 1e-12);
  EXPECT_NEAR(angles.pitch, -0.05, 1e-12);
  EXPECT_NEAR(RadToDeg(angles.yaw), -100.0, 1e-9);
}

TEST(HalfTurnIsNearer, ComparesYawsOnTheCircle) {
  for (const double turns : {-720.0, 0.0, 360.0}) {
    EXPECT_FALSE(HalfTurnIsNearer(DegToRad(170.0 + turns), DegToRad(-110.0)));
    EXPECT_TRUE(HalfTurnIsNearer(DegToRad(170.0 + turns), DegToRad(-90.0)));
    EXPECT_TRUE(HalfTurnIsNearer(DegToRad(10.0), DegToRad(170.0 + turns)));
  }
}

}  // namespace
}  // namespace touchdown::models
