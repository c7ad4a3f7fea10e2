#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

namespace touchdown::estimator::pad {

/// Five degrees of freedom of a circle's plane in the camera frame C (Sec. IV-C.1).
struct CirclePose {
  Eigen::Vector3d n_C = -Eigen::Vector3d::UnitZ();  ///< The plane's unit normal, the paper's n: Z_W in C.
  Eigen::Vector3d p_CW = Eigen::Vector3d::UnitZ();  ///< The circle's center, m, the paper's t_C^W.
};

/// Both poses from which a circle of `radius_m` looks like the ellipse `conic` (Eqs. 3 to 11). `conic` is the symmetric
/// matrix of Eq. 7 in normalized image coordinates (f = 1), at any scale and sign: X^T Q X = 0. The poses are equal
/// where the cone is one of revolution (lambda_1 = lambda_2): the optical center lies on the circle's axis, wherever in
/// the image the circle is then seen. nullopt when the conic is not finite or no cone (its eigenvalues are not of signs
/// -, +, + or +, -, -), or a center lies on the plane of the optical center.
std::optional<std::array<CirclePose, 2>> PosesOfCircle(const Eigen::Matrix3d& conic, double radius_m);

}  // namespace touchdown::estimator::pad
