#include "models/landing_pad.h"

#include <algorithm>
#include <cmath>

#include "models/angles.h"
#include "models/error.h"

namespace touchdown::models {
namespace {

/// Half a width from a file or a calculation may be off by a rounding, which is no gap between strokes.
constexpr double kNoGap_m = 1e-9;

}  // namespace

PadLetter LandingPad::letter() const {
  return h_width_m - 2.0 * h_stroke_m <= kNoGap_m ? PadLetter::kRectangle : PadLetter::kH;
}

void LandingPad::Validate() const {
  for (const double size :
       {outer_radius_m, ring_width_m, h_height_m, h_width_m, h_stroke_m, sheet_length_m, sheet_width_m}) {
    if (!std::isfinite(size) || size <= 0.0) throw InputError("the pad's sizes must be positive and finite");
  }
  if (ring_width_m >= outer_radius_m) throw InputError("the pad's ring must be narrower than its radius");
  if (h_width_m - 2.0 * h_stroke_m < -kNoGap_m || h_stroke_m >= h_height_m) {
    throw InputError("the pad's H must be at least as wide as its two strokes, and higher than one");
  }
  if (std::hypot(h_height_m, h_width_m) / 2.0 >= inner_radius_m()) {
    throw InputError("the pad's H must fit inside its ring with a white gap");
  }
  if (2.0 * outer_radius_m > std::min(sheet_length_m, sheet_width_m)) {
    throw InputError("the pad's ring must fit on its sheet");
  }
  for (const PadMark& mark : marks) mark.Validate(inner_radius_m());
}

bool HalfTurnIsNearer(double yaw, double reference_yaw) { return std::abs(WrapToPi(yaw - reference_yaw)) > kPi / 2.0; }

Eigen::Isometry3d ResolveYawAmbiguity(const Eigen::Isometry3d& X_WB, double reference_yaw) {
  if (!HalfTurnIsNearer(TaitBryanFromRotation(X_WB.linear()).yaw, reference_yaw)) return X_WB;
  const Eigen::Isometry3d half_turn(Eigen::Matrix3d(Eigen::Vector3d(-1.0, -1.0, 1.0).asDiagonal()));
  return half_turn * X_WB;
}

}  // namespace touchdown::models
