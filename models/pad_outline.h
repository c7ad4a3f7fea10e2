#pragma once

#include <Eigen/Core>
#include <variant>
#include <vector>

#include "models/landing_pad.h"

namespace touchdown::models {

/// A circle in the plane of W.
struct Circle {
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  double radius_m = 0.0;
};

/// A polygon in the plane of W whose sides do not cross.
struct Polygon {
  std::vector<Eigen::Vector2d> corners_m;  ///< Counter-clockwise, seen from above.
};

/// A closed shape of a pad's artwork, filled with one color.
struct PadShape {
  enum class Color { kBlack, kWhite };
  Color color = Color::kBlack;
  std::variant<Circle, Polygon> outline;

  /// Whether a point of the pad plane, in W, is on the shape. A border between black and white is black: a black shape
  /// includes its outline, a white one does not.
  bool Contains(const Eigen::Vector2d& p_W) const;
};

/// Artwork of a landing pad as shapes in the pad's frame W: the white sheet, the ring (a black circle and a white
/// circle within it), the letter (one black polygon) and the markings.
class PadOutline {
 public:
  /// `pad` must be valid.
  explicit PadOutline(const LandingPad& pad);

  /// All shapes, in the order of printing: each covers those before it. The first is the sheet.
  const std::vector<PadShape>& shapes() const { return shapes_; }

  /// Outline of the letter, which is symmetric about both axes of W.
  const Polygon& letter() const { return std::get<Polygon>(shapes_[kLetter].outline); }

  /// Whether a point of the pad plane, in W, is black: on the ring, the letter or a marking.
  bool IsBlack(const Eigen::Vector2d& p_W) const;

  /// Whether a point of the pad plane, in W, is on the letter.
  bool IsLetter(const Eigen::Vector2d& p_W) const { return shapes_[kLetter].Contains(p_W); }

  /// Unsigned distance of a point of the pad plane, in W, from the letter's outline, m.
  double DistanceFromLetter(const Eigen::Vector2d& p_W) const;

  /// Points along the letter's outline, in W, m, about `spacing_m` apart. They are symmetric about both axes, like the
  /// letter, so that a curve fitted to them is symmetric too.
  std::vector<Eigen::Vector2d> PointsAlongLetter(double spacing_m) const;

  /// Width of the narrowest black or white stripe of sheet, ring and letter, m: the smallest distance between two parts
  /// of their outlines that do not touch. Markings are ignored because they may touch or overlap the letter.
  double narrowest_m() const { return narrowest_m_; }

 private:
  enum { kSheet, kRingOuter, kRingInner, kLetter, kFirstMarking };  // The order of the shapes.

  /// A side of the letter, prepared for DistanceFromLetter.
  struct Side {
    Eigen::Vector2d from_m, along_m;
    double per_squared_length;  // 1/m^2
  };

  std::vector<PadShape> shapes_;
  std::vector<Eigen::Vector2d> letter_quarter_;  // Corners in the first quadrant, from the X axis to the Y axis.
  std::vector<Side> letter_sides_;
  double narrowest_m_;
};

/// Width of the polygon's narrowest part, black inside or white outside, m: the smallest distance between two sides
/// that do not share a corner.
double NarrowestPart(const Polygon& polygon);

}  // namespace touchdown::models
