#include "models/pad_marking.h"

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
using Shape = PadMarking::Shape;

constexpr double kRing_m = 0.074;

PadMarking Disc() { return {.shape = Shape::kDisc, .center_m = {0.02, 0.05}, .diameter_m = 0.01}; }

PadMarking Bar() {
  return {.shape = Shape::kBar, .center_m = {-0.02, 0.05}, .length_m = 0.02, .width_m = 0.004, .angle_deg = 30.0};
}

TEST(PadMarkingValidate, AcceptsMarkingsWithinTheRing) {
  for (const PadMarking& marking : {Disc(), Bar()}) EXPECT_NO_THROW(marking.Validate(kRing_m));
  PadMarking disc = Disc();
  disc.center_m = {0.0, -0.0689};
  EXPECT_NO_THROW(disc.Validate(kRing_m));
  PadMarking bar = Bar();
  bar.center_m = {0.0, 0.0639};
  bar.angle_deg = 90.0;
  EXPECT_NO_THROW(bar.Validate(kRing_m));
}

TEST(PadMarkingValidate, RejectsMarkingsThatDoNotFitInTheRing) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<std::pair<PadMarking, std::function<void(PadMarking&)>>> faults = {
      {Disc(), [](PadMarking& m) { m.diameter_m = 0.0; }},
      {Disc(), [](PadMarking& m) { m.diameter_m = std::nan(""); }},
      {Disc(), [](PadMarking& m) { m.diameter_m = 0.15; }},
      {Disc(), [&](PadMarking& m) { m.center_m.x() = infinity; }},
      {Disc(),
       [](PadMarking& m) {
         m.center_m = {0.0, -0.0691};
       }},
      {Bar(), [](PadMarking& m) { m.length_m = -0.01; }},
      {Bar(), [](PadMarking& m) { m.width_m = 0.0; }},
      {Bar(), [&](PadMarking& m) { m.length_m = infinity; }},
      {Bar(), [](PadMarking& m) { m.angle_deg = std::nan(""); }},
      {Bar(),
       [](PadMarking& m) {
         m.center_m = {0.1, 0.0};
       }},
      // The ends of the bar are within the ring, its corners are not.
      {Bar(), [](PadMarking& m) { m = {.shape = Shape::kBar, .length_m = 0.1479, .width_m = 0.01}; }},
  };
  for (std::size_t i = 0; i < faults.size(); ++i) {
    PadMarking marking = faults[i].first;
    faults[i].second(marking);
    EXPECT_THROW(marking.Validate(kRing_m), InputError) << "fault " << i;
  }
}

}  // namespace
}  // namespace touchdown::models
