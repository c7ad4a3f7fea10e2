#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>

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
  Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
  double diameter_m = 0.0;  ///< Disc only.
  double length_m = 0.0;    ///< Bar only.
  double width_m = 0.0;     ///< Bar only.
  double angle = 0.0;       ///< Bar only: of its length, from X towards Y.

  /// Throws InputError, without a file name, when a number is not finite, a size is not positive, or the
  /// mark does not lie wholly within the circle of `radius_m` around W's origin.
  void Validate(double radius_m) const;

  friend bool operator==(const PadMark&, const PadMark&) = default;
};

}  // namespace touchdown::models
