#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>

#include "estimator/pad/conic_pose.h"

namespace touchdown::estimator::paper {

/// Reference vector of Eqs. 12 and 13: the IMU's estimate of Z_W in C. `gravity_B` is the unit vector pointing down in
/// B. It depends on roll and pitch only, so that the yaw, which Eq. 12 sets to 0, is not needed.
Eigen::Vector3d ReferenceNormal(const Eigen::Vector3d& gravity_B, const Eigen::Matrix3d& R_BC);

/// Index of the pose whose normal makes the smaller angle with the reference vector z_C (Eq. 14).
std::size_t ResolveByGravity(const std::array<pad::CirclePose, 2>& poses, const Eigen::Vector3d& z_C);

/// Probability that Eq. 14 selects the wrong one of `poses`. The two angle errors of the reference vector z_C have the
/// standard deviation `reference_sigma`, rad, and both poses are equally likely a priori. The result is 0.5 if both
/// normals are equally far from the reference, and nearly 0 if the other one is several sigma farther away.
double WrongBranchProbability(const std::array<pad::CirclePose, 2>& poses, const Eigen::Vector3d& z_C,
                              double reference_sigma);

/// The camera's yaw psi_C, rad, from the direction of the H's long strokes in the undistorted, not rectified image
/// (Sec. IV-C.3).
///
/// `stroke_angle` is measured from +u towards +v, rad. psi_C is the angle about Z_W from X_W to the image's up
/// direction. The H has a 180-degree yaw ambiguity; the result is the solution with the body's yaw within +-90 degrees.
/// For the nominal mounting the body's yaw equals the camera's.
double CameraYaw(double stroke_angle, const Eigen::Matrix3d& R_BC);

/// R_WC from the pad's normal in C and the camera's yaw, rad (Eq. 15).
///
/// Eq. 15 as printed rotates n onto Z_C. For a camera that looks down this is a rotation by nearly 180 degrees about an
/// undefined axis. Here n is rotated onto -Z_C by the shortest rotation R_LC, which is nearly the identity near hover,
/// followed by the constant rotation R_WL from a camera that looks straight down to W: R_WC = Rz(psi_C) R_WL R_LC(n).
Eigen::Matrix3d CameraRotation(const Eigen::Vector3d& n_C, double psi_C);

/// X_WB from R_WC, the pad's position p_CW, m, and the camera's mounting X_BC (Eqs. 17 and 18).
Eigen::Isometry3d BodyPose(const Eigen::Matrix3d& R_WC, const Eigen::Vector3d& p_CW, const Eigen::Isometry3d& X_BC);

}  // namespace touchdown::estimator::paper
