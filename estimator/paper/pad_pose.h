#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>

#include "estimator/pad/conic_pose.h"

namespace touchdown::estimator::paper {

/// Z_W in C as the IMU has it, the reference vector of Eqs. 12 and 13. `gravity_B` is the unit vector pointing down in
/// B; roll and pitch enter through it, and yaw, which Eq. 12 sets to 0, does not.
Eigen::Vector3d ReferenceNormal(const Eigen::Vector3d& gravity_B, const Eigen::Matrix3d& R_BC);

/// Index of the pose whose normal makes the smaller angle with the reference vector z_C (Eq. 14).
std::size_t ResolveByGravity(const std::array<pad::CirclePose, 2>& poses, const Eigen::Vector3d& z_C);

/// The probability that Eq. 14 took the wrong one of `poses` when each of the reference's two angles to z_C has the
/// 1-sigma error `reference_sigma`, rad, and both poses were as likely before: 0.5 where they are equally far from the
/// reference, nearly 0 where the other one is several sigma further off.
double WrongBranchProbability(const std::array<pad::CirclePose, 2>& poses, const Eigen::Vector3d& z_C,
                              double reference_sigma);

/// The camera's yaw psi_C from the direction of the H's long strokes in the undistorted image, not rectified
/// (Sec. IV-C.3). `stroke_angle` is from +u towards +v. psi_C is the angle about Z_W from X_W to the image's up. An H
/// looks the same turned by 180 degrees: of both answers, the one that leaves the body's yaw within +-90 degrees, which
/// for the nominal mounting is the camera's.
double CameraYaw(double stroke_angle, const Eigen::Matrix3d& R_BC);

/// R_WC from the pad's normal in C and the camera's yaw (Eq. 15).
///
/// Eq. 15 as printed turns n onto Z_C, which for a camera that looks down is a turn by nearly 180 degrees about an
/// undefined axis. Here n is turned onto -Z_C by the shortest way, which near hover is nearly the identity, and the
/// constant turn from an image looking straight down to W follows: R_WC = Rz(psi_C) R_WL R_LC(n).
Eigen::Matrix3d CameraRotation(const Eigen::Vector3d& n_C, double psi_C);

/// X_WB from R_WC, the pad's place p_CW and the camera's mounting (Eqs. 17 and 18).
Eigen::Isometry3d BodyPose(const Eigen::Matrix3d& R_WC, const Eigen::Vector3d& p_CW, const Eigen::Isometry3d& X_BC);

}  // namespace touchdown::estimator::paper
