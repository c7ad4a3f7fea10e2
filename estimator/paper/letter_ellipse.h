#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>

#include "estimator/pad/ellipse_fit.h"
#include "models/landing_pad.h"

namespace touchdown::estimator::paper {

/// Ellipse fitted to the outline of the pad's letter, whose major axis gives the direction of the letter (Sec. IV-C.3).
class LetterEllipse {
 public:
  /// Throws InputError when the pad is invalid.
  explicit LetterEllipse(const models::LandingPad& pad);

  /// Whether the ellipse determines the direction of the letter. It does not if the letter is nearly as wide as high.
  bool HasDirection() const;

  /// Direction of the H's long strokes in the image, from the ellipse fitted to the letter in the image: that of the
  /// major axis for an H that is higher than wide, and perpendicular to it for a wider one. The angle is from the first
  /// coordinate axis towards the second, rad, (-pi/2, pi/2].
  double StrokeAngle(const pad::Ellipse& image_ellipse) const;

  /// StrokeAngle of the letter projected into the normalized image of a camera at X_CW, rad. It includes the effect of
  /// perspective, as the direction of the strokes in Sec. IV-C.3 does. If the ellipse has no direction, the result is
  /// the projected direction of the X axis. nullopt when the projection of the ellipse is not an ellipse.
  std::optional<double> ProjectedStrokeAngle(const Eigen::Isometry3d& X_CW) const;

 private:
  double half_height_m_;
  pad::Ellipse in_pad_;  // In the plane of W, m.
};

}  // namespace touchdown::estimator::paper
