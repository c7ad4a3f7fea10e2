#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>

#include "estimator/pad/ellipse_fit.h"
#include "models/landing_pad.h"

namespace touchdown::estimator::paper {

/// The ellipse that the direct fit gives for the outline of the pad's letter H, and what its major axis tells of the H
/// (Sec. IV-C.3).
class LetterEllipse {
 public:
  /// Throws InputError when the pad is impossible.
  explicit LetterEllipse(const models::LandingPad& pad);

  /// Whether the ellipse tells the H's direction: not where the H is nearly as wide as high.
  bool HasDirection() const;

  /// Direction of the H's long strokes in the image, from the major axis of the ellipse fitted to the H there: the same
  /// for an H that is higher than wide, across it for a wider one. From the first coordinate's axis towards the
  /// second's, (-pi/2, pi/2].
  double StrokeAngle(const pad::Ellipse& seen) const;

  /// The StrokeAngle of the H in the normalized image of a camera at X_CW: what Sec. IV-C.3 takes for the direction of
  /// the strokes, perspective and all; where the ellipse has no direction, that of the H's X axis.
  /// nullopt where the H's ellipse is not seen as an ellipse.
  std::optional<double> StrokeAngleSeenFrom(const Eigen::Isometry3d& X_CW) const;

 private:
  double half_height_m_;
  pad::Ellipse in_pad_;  // In the plane of W, m.
};

}  // namespace touchdown::estimator::paper
