#include "models/landing_pad.h"

#include <algorithm>
#include <cmath>

#include "models/angles.h"
#include "models/error.h"

namespace touchdown::models {
namespace {

/// Tolerance, m: strokes whose gap is smaller meet. A stroke of half the width may be off by rounding.
constexpr double kNoGap_m = 1e-9;

void RequirePrintable(const LandingPad& pad) {
  if (pad.ring_width_m >= pad.outer_radius_m) {
    throw InputError("the pad's ring_width_m must be less than its outer_radius_m");
  }
  if (pad.h_width_m - 2.0 * pad.h_stroke_m < -kNoGap_m || pad.h_stroke_m >= pad.h_height_m) {
    throw InputError("the pad's h_width_m must be at least 2 h_stroke_m, and its h_height_m above h_stroke_m");
  }
  if (std::hypot(pad.h_height_m, pad.h_width_m) / 2.0 >= pad.inner_radius_m()) {
    throw InputError("the pad's H must fit inside its ring with a white gap");
  }
  if (2.0 * pad.outer_radius_m > std::min(pad.sheet_length_m, pad.sheet_width_m)) {
    throw InputError("the pad's ring must fit on its sheet");
  }
}

}  // namespace

PadLetter LandingPad::letter() const {
  return h_width_m - 2.0 * h_stroke_m <= kNoGap_m ? PadLetter::kRectangle : PadLetter::kH;
}

void LandingPad::Validate() const { ValidateConfig(*this); }

void Describe(ConfigVisitor& v, LandingPad& c) {
  v.Number({"outer_radius_m", "Outer radius of the ring."}, c.outer_radius_m, kMeter, kPositive);
  v.Number({"ring_width_m", "Width of the ring's black line."}, c.ring_width_m, kMeter, kPositive);
  v.Number({"h_height_m", "Length of the H's long strokes, along X."}, c.h_height_m, kMeter, kPositive);
  v.Number({"h_width_m", "Width of the H including both long strokes, along Y."}, c.h_width_m, kMeter, kPositive);
  v.Number({"h_stroke_m", "Width of the H's strokes. A value of half h_width_m makes the H a solid rectangle."},
           c.h_stroke_m, kMeter, kPositive);
  v.Number({"sheet_length_m", "Length of the white sheet, along X."}, c.sheet_length_m, kMeter, kPositive);
  v.Number({"sheet_width_m", "Width of the white sheet, along Y."}, c.sheet_width_m, kMeter, kPositive);
  v.List(
      {"marks", "Additional black markings within the ring. They may touch or overlap the H."}, c.marks.size(),
      [&c](std::size_t count) { c.marks.assign(count, {}); },
      [&c](ConfigVisitor& item, std::size_t index) {
        Describe(item, c.marks[index]);
        item.Check("", [&c, index] { c.marks[index].Validate(c.inner_radius_m()); });
      });
  v.Check("", [&c] { RequirePrintable(c); });
}

bool HalfTurnIsNearer(double yaw, double reference_yaw) { return std::abs(WrapToPi(yaw - reference_yaw)) > kPi / 2.0; }

Eigen::Isometry3d ResolveYawAmbiguity(const Eigen::Isometry3d& X_WB, double reference_yaw) {
  if (!HalfTurnIsNearer(TaitBryanFromRotation(X_WB.linear()).yaw, reference_yaw)) return X_WB;
  const Eigen::Isometry3d half_turn(Eigen::Matrix3d(Eigen::Vector3d(-1.0, -1.0, 1.0).asDiagonal()));
  return half_turn * X_WB;
}

}  // namespace touchdown::models
