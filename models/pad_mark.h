#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>

#include "models/describe.h"

namespace touchdown::models {

/// A black mark printed on a landing pad within its ring, beside the H or over it: a disc or a bar. In the pad's frame
/// W.
struct PadMark {
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

  /// Throws InputError, without a file name, for a value out of its range (see Describe), or when the mark does not lie
  /// wholly within the circle of `radius_m` around W's origin.
  void Validate(double radius_m) const;

  friend bool operator==(const PadMark&, const PadMark&) = default;
};

void Describe(ConfigVisitor& v, PadMark& mark);

}  // namespace touchdown::models
