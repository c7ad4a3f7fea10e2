#include "models/pad_mark.h"

#include <Eigen/Geometry>
#include <cmath>

#include "models/error.h"

namespace touchdown::models {
namespace {

/// From W's origin to the mark's farthest point.
double Reach(const PadMark& mark) {
  if (mark.shape == PadMark::Shape::kDisc) return mark.centre_m.norm() + 0.5 * mark.diameter_m;
  const Eigen::Vector2d along_bar = Eigen::Rotation2Dd(-mark.angle) * mark.centre_m;
  return (along_bar.cwiseAbs() + 0.5 * Eigen::Vector2d(mark.length_m, mark.width_m)).norm();
}

bool HasSize(const PadMark& mark) {
  const auto is_size = [](double value) { return std::isfinite(value) && value > 0.0; };
  if (mark.shape == PadMark::Shape::kDisc) return is_size(mark.diameter_m);
  return is_size(mark.length_m) && is_size(mark.width_m);
}

}  // namespace

void PadMark::Validate(double radius_m) const {
  if (!HasSize(*this)) throw InputError("the sizes of a pad's mark must be positive and finite");
  if (!centre_m.allFinite() || !std::isfinite(angle)) throw InputError("a pad's mark must lie at a finite place");
  if (Reach(*this) >= radius_m) throw InputError("a pad's mark must lie wholly within its ring, with a white gap");
}

}  // namespace touchdown::models
