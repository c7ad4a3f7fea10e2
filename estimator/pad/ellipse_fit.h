#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "models/camera_model.h"

namespace touchdown::estimator::pad {

/// An ellipse in a plane, in the units of the points that it was fitted to.
struct Ellipse {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Eigen::Vector2d semi_axes = Eigen::Vector2d::Ones();  ///< The major one first.
  double angle = 0.0;  ///< Of the major axis, from the first coordinate's axis towards the second's, (-pi/2, pi/2].

  /// Symmetric C with (x, y, 1) C (x, y, 1)^T = 0 on the ellipse, negative inside (Eq. 4).
  Eigen::Matrix3d Conic() const;

  /// R diag(a^2, b^2) R^T: the ellipse is (x - center)^T Shape()^-1 (x - center) = 1.
  Eigen::Matrix2d Shape() const;

  /// The ellipse with this center and this Shape(); nullopt when the shape is not positive definite, or a number not
  /// finite.
  static std::optional<Ellipse> FromShape(const Eigen::Vector2d& center, const Eigen::Matrix2d& shape);

  /// The ellipse of a conic at any scale and sign; nullopt when it is not a real ellipse.
  static std::optional<Ellipse> FromConic(const Eigen::Matrix3d& conic);
};

/// Direct least-squares fit (Fitzgibbon, Pilu, Fisher: Direct least square fitting of ellipses, IEEE PAMI 21(5), 1999,
/// the paper's [9]) in the numerically stable form of Halir and Flusser (1998), on points moved to their centroid and
/// scaled. nullopt for fewer than 6 points, and for points that fix no ellipse (all on a line, not finite).
std::optional<Ellipse> FitEllipse(std::span<const Eigen::Vector2d> points);

/// First-order (Sampson's) signed distance of a point from the ellipse, positive outside.
double DistanceFrom(const Ellipse& ellipse, const Eigen::Vector2d& point);

/// Root mean square of DistanceFrom over the points, of which there must be at least one.
double RmsDistance(const Ellipse& ellipse, std::span<const Eigen::Vector2d> points);

struct RingFitConfig {
  /// Points no further from their ellipse than this are never left out, and twice as much as a root mean square is
  /// never too much: Canny's whole pixels alone are off by 0.35 px.
  double exact_px = 0.3;
  /// Of the points that are not left out, the largest root mean square, over the ellipse's smaller semi-axis: paper
  /// that curls makes no ellipse.
  double largest_rms_share = 0.05;
  /// What share of the ellipse's circumference the rest must cover: where less is seen, something lies over the ring.
  double least_coverage = 0.85;

  /// Throws InputError when a number is not finite and positive, or the coverage above 1.
  void Validate() const;
};

/// The ellipse of a ring's outer boundary; of `points`, those stay that lie on it, but for those beside a gap, where
/// what covers the ring bends its edge. nullopt when they make no ellipse, or cover too little of it.
std::optional<Ellipse> FitRing(std::vector<Eigen::Vector2d>& points, const RingFitConfig& config = {});

/// From undistorted pixels of `camera` to normalized coordinates.
Eigen::Matrix3d NormalizedConic(const Ellipse& ellipse, const models::CameraModel& camera);

}  // namespace touchdown::estimator::pad
