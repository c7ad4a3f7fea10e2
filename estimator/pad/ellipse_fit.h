#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "models/camera_model.h"

namespace touchdown::estimator::pad {

/// Ellipse in a plane, in the units of the points that it was fitted to.
struct Ellipse {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Eigen::Vector2d semi_axes = Eigen::Vector2d::Ones();  ///< The major semi-axis first.
  /// Angle of the major axis, from the first coordinate axis towards the second, rad, (-pi/2, pi/2].
  double angle = 0.0;

  /// Symmetric matrix C with (x, y, 1) C (x, y, 1)^T = 0 on the ellipse, negative inside (Eq. 4).
  Eigen::Matrix3d Conic() const;

  /// Shape matrix R diag(a^2, b^2) R^T: the ellipse is (x - center)^T Shape()^-1 (x - center) = 1.
  Eigen::Matrix2d Shape() const;

  /// The ellipse with the given center and Shape(); nullopt when the shape is not positive definite or a value is not
  /// finite.
  static std::optional<Ellipse> FromShape(const Eigen::Vector2d& center, const Eigen::Matrix2d& shape);

  /// The ellipse of a conic matrix at any scale and sign; nullopt when the conic is not a real ellipse.
  static std::optional<Ellipse> FromConic(const Eigen::Matrix3d& conic);
};

/// Direct least-squares fit of an ellipse (Fitzgibbon, Pilu, Fisher: Direct least square fitting of ellipses, IEEE PAMI
/// 21(5), 1999, the paper's [9]) in the numerically stable form of Halir and Flusser (1998). The points are first
/// translated to their centroid and scaled. nullopt for fewer than 6 points, and for points that do not determine an
/// ellipse (collinear or not finite).
std::optional<Ellipse> FitEllipse(std::span<const Eigen::Vector2d> points);

/// First-order (Sampson) signed distance from the ellipse to a point, positive outside.
double DistanceFrom(const Ellipse& ellipse, const Eigen::Vector2d& point);

/// Root mean square of DistanceFrom over the points. `points` must not be empty.
double RmsDistance(const Ellipse& ellipse, std::span<const Eigen::Vector2d> points);

/// Settings of FitRing.
struct RingFitConfig {
  /// Points within this distance of the ellipse are never outliers, and a fit with an RMS distance of at most twice
  /// this value is always accepted. Canny's integer pixels alone have an error of 0.35 px.
  double tolerance_px = 0.3;
  /// Largest RMS distance of the inliers, relative to the minor semi-axis. A larger value accepts paper with more curl.
  double max_relative_rms = 0.05;
  /// Smallest fraction of the circumference that the inliers must cover. A smaller fraction means that an object
  /// occludes the ring.
  double min_coverage = 0.85;

  /// Throws InputError when a value is not finite and positive, or min_coverage is above 1.
  void Validate() const;
};

/// Fits an ellipse to the outer boundary of a ring and removes outliers from `points`. It also removes the points next
/// to a gap, where the occluding object distorts the ring's edge. nullopt when the points do not fit an ellipse or
/// cover too little of it.
std::optional<Ellipse> FitRing(std::vector<Eigen::Vector2d>& points, const RingFitConfig& config = {});

/// The conic matrix of an ellipse in normalized coordinates, given the ellipse in undistorted pixels of `camera`.
Eigen::Matrix3d NormalizedConic(const Ellipse& ellipse, const models::CameraModel& camera);

}  // namespace touchdown::estimator::pad
