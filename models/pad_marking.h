#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>

#include "models/describe.h"

namespace touchdown::models {

/// A black marking on a landing pad within its ring, next to the H or overlapping it: a disc or a bar. Coordinates are
/// in the pad's frame W.
struct PadMarking {
  enum class Shape {
    kDisc,
    kBar,  ///< A rectangle.
  };
  static constexpr std::array<std::string_view, 2> kShapeNames = {"disc", "bar"};

  Shape shape = Shape::kDisc;
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  double diameter_m = 0.0;
  double length_m = 0.0;
  double width_m = 0.0;
  double angle_deg = 0.0;

  /// Throws InputError, without a file name, for a value out of its range (see Describe), or when the marking is not
  /// entirely within the circle of `radius_m` around W's origin.
  void Validate(double radius_m) const;

  friend bool operator==(const PadMarking&, const PadMarking&) = default;
};

void Describe(ConfigVisitor& v, PadMarking& marking);

}  // namespace touchdown::models
