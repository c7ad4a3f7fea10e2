#include "models/pad_mark.h"

#include <Eigen/Geometry>
#include <cmath>

#include "models/error.h"

namespace touchdown::models {
namespace {

/// Coordinates along the bar's length and width of a point or direction of W.
Eigen::Vector2d AlongBar(const PadMark& bar, const Eigen::Vector2d& v_W) {
  return Eigen::Rotation2Dd(-bar.angle) * v_W;
}

Eigen::Vector2d HalfSize(const PadMark& bar) { return 0.5 * Eigen::Vector2d(bar.length_m, bar.width_m); }

/// From W's origin to the mark's farthest point.
double Reach(const PadMark& mark) {
  if (mark.shape == PadMark::Shape::kDisc) return mark.centre_m.norm() + 0.5 * mark.diameter_m;
  return (AlongBar(mark, mark.centre_m).cwiseAbs() + HalfSize(mark)).norm();
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

bool PadMark::Holds(const Eigen::Vector2d& p_W) const {
  const Eigen::Vector2d from_centre = p_W - centre_m;
  if (shape == Shape::kDisc) return from_centre.norm() <= 0.5 * diameter_m;
  return (AlongBar(*this, from_centre).cwiseAbs() - HalfSize(*this)).maxCoeff() <= 0.0;
}

}  // namespace touchdown::models
