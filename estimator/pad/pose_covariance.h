#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "estimator/pad/ellipse_fit.h"

namespace touchdown::estimator::pad {

/// Settings of the pose covariance.
struct PoseCovarianceConfig {
  /// Smallest standard deviation of an edge point, px, from the residual effect of the pixel grid.
  double min_edge_sigma_px = 0.02;
  /// Number of edge points that count as one independent point, because neighboring points share pixels and errors.
  double points_per_independent_point = 3.0;
  /// Standard deviation of the angle between the ellipse fitted to a letter H and the H itself, rad.
  double letter_sigma_rad = 0.01;
  /// Standard deviation of the IMU's vertical, rad. A larger value increases the probability that gravity selects the
  /// wrong pose hypothesis.
  double gravity_sigma_rad = 0.02;
  /// Standard deviations added to every pose, for errors that the edge points do not show.
  double added_position_sigma_m = 0.0005;
  double added_angle_sigma_rad = 0.001;

  /// Throws InputError when a value is not finite and positive.
  void Validate() const;
};

/// Parameters (center u, center v, S_uu, S_uv, S_vv) of an ellipse, with S = Ellipse::Shape(). They vary smoothly even
/// for a circle, whose axes are undefined.
using EllipseParameters = Eigen::Matrix<double, 5, 1>;

/// The parameters of an ellipse.
EllipseParameters ParametersOf(const Ellipse& ellipse);

/// The ellipse with these parameters; nullopt when S is not positive definite or a value is not finite.
std::optional<Ellipse> EllipseOf(const EllipseParameters& parameters);

/// Covariance of the parameters of an ellipse fitted to `points`.
///
/// Each point is assumed to have a normal error perpendicular to the ellipse; its variance is estimated from the
/// distances of the points. The result is the first-order covariance of the geometric fit, which the direct fit
/// approximates. nullopt for fewer than 6 points or when they do not determine the parameters.
std::optional<Eigen::Matrix<double, 5, 5>> EllipseCovariance(const Ellipse& ellipse,
                                                             std::span<const Eigen::Vector2d> points,
                                                             const PoseCovarianceConfig& config = {});

/// Standard deviation of the direction of the H's strokes in the image, rad.
///
/// The ellipse `letter` was fitted to `point_count` points, each with standard deviation `edge_sigma_px`.
/// `not_rectified` is the angle by which perspective rotates the ellipse relative to the strokes at the estimated pose,
/// rad. Sec. IV-C.3 does not correct the yaw for it, so that it counts as an error.
double StrokeSigma(const Ellipse& letter, std::size_t point_count, double edge_sigma_px, double not_rectified,
                   const PoseCovarianceConfig& config = {});

/// 6x6 covariance of (p_WB in m, rotation vector in W in rad) about `X_WB`.
///
/// `ring_covariance` is the covariance of the ring's ellipse, and `stroke_sigma` the standard deviation of the strokes'
/// direction in the image, rad. Both are propagated through `pose_of`, the map from them to the pose, with 12 sigma
/// points. Derivatives are not used: for a nearly circular ellipse the tilt is proportional to the square root of the
/// flattening, which has no derivative at 0.
///
/// The step to a sigma point without a pose is halved until the point has a pose, and the change of the pose is scaled
/// up by the same factor. For a linear map this has no effect; for a square root it increases the change. The
/// covariance therefore does not shrink when distant sigma points have no pose. nullopt when a point has no pose at
/// 1/64 of its step either.
std::optional<Eigen::Matrix<double, 6, 6>> PoseCovariance(
    const Ellipse& ring, const Eigen::Matrix<double, 5, 5>& ring_covariance, double stroke_angle, double stroke_sigma,
    const Eigen::Isometry3d& X_WB,
    const std::function<std::optional<Eigen::Isometry3d>(const Ellipse& ring, double stroke_angle)>& pose_of,
    const PoseCovarianceConfig& config = {});

/// Term added to the covariance about `X_WB` because `other_X_WB` is the true pose with probability `probability`: the
/// outer product of the difference of the two poses, times `probability`.
Eigen::Matrix<double, 6, 6> WrongBranchCovariance(const Eigen::Isometry3d& X_WB, const Eigen::Isometry3d& other_X_WB,
                                                  double probability);

}  // namespace touchdown::estimator::pad
