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

PadMark Disc() { return {.shape = Shape::kDisc, .center_m = {0.02, 0.05}, .diameter_m = 0.01}; }

PadMark Bar() {
  return {.shape = Shape::kBar, .center_m = {-0.02, 0.05}, .length_m = 0.02, .width_m = 0.004, .angle_deg = 30.0};
}

TEST(PadMarkValidate, TakesWhatLiesWithinTheRing) {
  for (const PadMark& mark : {Disc(), Bar()}) EXPECT_NO_THROW(mark.Validate(kRing_m));
  PadMark disc = Disc();
  disc.center_m = {0.0, -0.0689};
  EXPECT_NO_THROW(disc.Validate(kRing_m));
  PadMark bar = Bar();
  bar.center_m = {0.0, 0.0639};
  bar.angle_deg = 90.0;
  EXPECT_NO_THROW(bar.Validate(kRing_m));
}

TEST(PadMarkValidate, RefusesWhatCannotBePrintedWithinTheRing) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<std::pair<PadMark, std::function<void(PadMark&)>>> faults = {
      {Disc(), [](PadMark& m) { m.diameter_m = 0.0; }},
      {Disc(), [](PadMark& m) { m.diameter_m = std::nan(""); }},
      {Disc(), [](PadMark& m) { m.diameter_m = 0.15; }},
      {Disc(), [&](PadMark& m) { m.center_m.x() = infinity; }},
      {Disc(),
       [](PadMark& m) {
         m.center_m = {0.0, -0.0691};
       }},
      {Bar(), [](PadMark& m) { m.length_m = -0.01; }},
      {Bar(), [](PadMark& m) { m.width_m = 0.0; }},
      {Bar(), [&](PadMark& m) { m.length_m = infinity; }},
      {Bar(), [](PadMark& m) { m.angle_deg = std::nan(""); }},
      {Bar(),
       [](PadMark& m) {
         m.center_m = {0.1, 0.0};
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
