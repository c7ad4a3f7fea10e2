#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "estimator/pad/ellipse_fit.h"

namespace touchdown::estimator::pad {

struct PoseCovarianceConfig {
  /// What an edge point is off by at least, 1-sigma, px: what is left of the pixels' grid.
  double smallest_edge_sigma_px = 0.02;
  /// Neighboring edge points share pixels, and so errors: this many count as one.
  double points_per_independent_point = 3.0;
  /// 1-sigma of the direction of the ellipse fitted to a letter H against that of the H, rad.
  double letter_sigma_rad = 0.01;
  /// 1-sigma of the IMU's vertical: the further off it may be, the sooner gravity picks the wrong one of two solutions.
  double gravity_sigma_rad = 0.02;
  /// Added to every pose's: whatever the edges do not show.
  double smallest_position_sigma_m = 0.0005;
  double smallest_angle_sigma_rad = 0.001;

  /// Throws InputError when a number is not finite and positive.
  void Validate() const;
};

/// An ellipse as the parameters (center u, center v, S_uu, S_uv, S_vv) with S = Ellipse::Shape(), which vary smoothly
/// even where the ellipse is a circle and has no axes.
using EllipseParameters = Eigen::Matrix<double, 5, 1>;
EllipseParameters ParametersOf(const Ellipse& ellipse);
/// nullopt when S is not positive definite, or a number not finite.
std::optional<Ellipse> EllipseOf(const EllipseParameters& parameters);

/// Covariance of the parameters of an ellipse fitted to `points`, each off by a normal error across the ellipse, whose
/// size is taken from the points' own distances: the first-order covariance of the geometric fit, which the direct fit
/// comes close to. nullopt for fewer points than 6 or when they do not fix the parameters.
std::optional<Eigen::Matrix<double, 5, 5>> EllipseCovariance(const Ellipse& ellipse,
                                                             std::span<const Eigen::Vector2d> points,
                                                             const PoseCovarianceConfig& config = {});

/// 1-sigma error of the direction of the H's strokes in the image, rad, when the ellipse `letter` was fitted to
/// `point_count` points off by `edge_sigma_px` each, and `not_rectified` is by how much perspective turns the ellipse
/// away from the strokes at the pose found: Sec. IV-C.3 leaves it in the yaw, so that it counts as an error.
double StrokeSigma(const Ellipse& letter, std::size_t point_count, double edge_sigma_px, double not_rectified,
                   const PoseCovarianceConfig& config = {});

/// 6x6 covariance of (p_WB in m, rotation vector in W in rad) about `X_WB` when the ring's ellipse has the covariance
/// `ring_covariance` and the strokes' direction in the image the 1-sigma error `stroke_sigma`. Both are carried through
/// `pose_of`, the map from them to the pose, by 12 sigma points rather than by derivatives: where the ellipse is nearly
/// a circle the tilt goes with the square root of its flattening and has no derivative. A sigma point without a pose is
/// brought halfway to the mean until it has one, and what it does to the pose is scaled up by as much: the pose moves
/// as far as on the way there, and for a map that bends like a square root further, so that the claim does not shrink
/// where the points that are far off fail. nullopt where there is no pose at 1/64 of the way either.
std::optional<Eigen::Matrix<double, 6, 6>> PoseCovariance(
    const Ellipse& ring, const Eigen::Matrix<double, 5, 5>& ring_covariance, double stroke_angle, double stroke_sigma,
    const Eigen::Isometry3d& X_WB,
    const std::function<std::optional<Eigen::Isometry3d>(const Ellipse& ring, double stroke_angle)>& pose_of,
    const PoseCovarianceConfig& config = {});

/// What the chance of having taken the wrong one of two solutions adds to the covariance about `X_WB`: the square of
/// their difference, times `probability`.
Eigen::Matrix<double, 6, 6> WrongBranchCovariance(const Eigen::Isometry3d& X_WB, const Eigen::Isometry3d& other_X_WB,
                                                  double probability);

}  // namespace touchdown::estimator::pad
