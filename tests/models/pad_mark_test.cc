#include "models/pad_mark.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "models/angles.h"
#include "models/error.h"

namespace touchdown::models {
namespace {

using Eigen::Vector2d;
using Shape = PadMark::Shape;

constexpr double kRing_m = 0.074;

PadMark Disc() { return {.shape = Shape::kDisc, .centre_m = {0.02, 0.05}, .diameter_m = 0.01}; }

PadMark Bar() {
  return {.shape = Shape::kBar, .centre_m = {-0.02, 0.05}, .length_m = 0.02, .width_m = 0.004, .angle_deg = 30.0};
}

TEST(PadMark, HoldsADisc) {
  const PadMark disc = Disc();
  EXPECT_TRUE(disc.Holds(disc.centre_m));
  for (double angle = 0.0; angle < 2.0 * kPi; angle += 0.1) {
    const Vector2d direction(std::cos(angle), std::sin(angle));
    EXPECT_TRUE(disc.Holds(disc.centre_m + 0.00499 * direction));
    EXPECT_FALSE(disc.Holds(disc.centre_m + 0.00501 * direction));
  }
}

TEST(PadMark, HoldsABarWhoseLengthIsTurnedFromXTowardsY) {
  const PadMark bar = Bar();
  const Vector2d along(std::cos(DegToRad(30.0)), 0.5), across(-0.5, std::cos(DegToRad(30.0)));
  for (const double side : {-1.0, 1.0}) {
    EXPECT_TRUE(bar.Holds(bar.centre_m + side * 0.00999 * along));
    EXPECT_FALSE(bar.Holds(bar.centre_m + side * 0.01001 * along));
    EXPECT_TRUE(bar.Holds(bar.centre_m + side * 0.00199 * across));
    EXPECT_FALSE(bar.Holds(bar.centre_m + side * 0.00201 * across));
    EXPECT_TRUE(bar.Holds(bar.centre_m + side * (0.00999 * along + 0.00199 * across))) << "a corner";
  }
  EXPECT_FALSE(bar.Holds(bar.centre_m + 0.0095 * Vector2d(along.x(), -along.y()))) << "turned the other way";
}

TEST(PadMarkValidate, TakesWhatLiesWithinTheRing) {
  for (const PadMark& mark : {Disc(), Bar()}) EXPECT_NO_THROW(mark.Validate(kRing_m));
  PadMark disc = Disc();
  disc.centre_m = {0.0, -0.0689};
  EXPECT_NO_THROW(disc.Validate(kRing_m));
  PadMark bar = Bar();
  bar.centre_m = {0.0, 0.0639};
  bar.angle_deg = 90.0;
  EXPECT_NO_THROW(bar.Validate(kRing_m));
}

TEST(PadMarkValidate, RefusesWhatCannotBePrintedWithinTheRing) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<std::pair<PadMark, std::function<void(PadMark&)>>> faults = {
      {Disc(), [](PadMark& m) { m.diameter_m = 0.0; }},
      {Disc(), [](PadMark& m) { m.diameter_m = std::nan(""); }},
      {Disc(), [](PadMark& m) { m.diameter_m = 0.15; }},
      {Disc(), [&](PadMark& m) { m.centre_m.x() = infinity; }},
      {Disc(),
       [](PadMark& m) {
         m.centre_m = {0.0, -0.0691};
       }},
      {Bar(), [](PadMark& m) { m.length_m = -0.01; }},
      {Bar(), [](PadMark& m) { m.width_m = 0.0; }},
      {Bar(), [&](PadMark& m) { m.length_m = infinity; }},
      {Bar(), [](PadMark& m) { m.angle_deg = std::nan(""); }},
      {Bar(),
       [](PadMark& m) {
         m.centre_m = {0.1, 0.0};
       }},
      // Its ends lie within the ring, its corners do not.
      {Bar(), [](PadMark& m) { m = {.shape = Shape::kBar, .length_m = 0.1479, .width_m = 0.01}; }},
  };
  for (std::size_t i = 0; i < faults.size(); ++i) {
    PadMark mark = faults[i].first;
    faults[i].second(mark);
    EXPECT_THROW(mark.Validate(kRing_m), InputError) << "fault " << i;
  }
}

}  // namespace
}  // namespace touchdown::models
