#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

namespace touchdown::estimator::pad {

/// Pose of a circle in the camera frame C, with five degrees of freedom (Sec. IV-C.1).
struct CirclePose {
  Eigen::Vector3d n_C = -Eigen::Vector3d::UnitZ();  ///< Unit normal of the circle's plane: the paper's n, Z_W in C.
  Eigen::Vector3d p_CW = Eigen::Vector3d::UnitZ();  ///< Center of the circle, m: the paper's t_C^W.
};

/// The two poses at which a circle of radius `radius_m` projects to the ellipse `conic` (Eqs. 3 to 11).
///
/// `conic` is the symmetric matrix Q of Eq. 7 in normalized image coordinates (f = 1), at any scale and sign, with
/// X^T Q X = 0. The poses are equal for a cone of revolution (lambda_1 = lambda_2), where the optical center lies on
/// the axis of the circle. Returns nullopt when the conic is not finite, when it is not a cone (its eigenvalues do not
/// have the signs -, +, + or +, -, -), or when a center lies in the plane z = 0 of the camera.
std::optional<std::array<CirclePose, 2>> PosesOfCircle(const Eigen::Matrix3d& conic, double radius_m);

}  // namespace touchdown::estimator::pad
