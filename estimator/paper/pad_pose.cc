#include "estimator/paper/pad_pose.h"

#include <cmath>

#include "models/angles.h"

namespace touchdown::estimator::paper {
namespace {

/// Rotation from frame L to W. L is a camera frame that looks straight down, with the image's up direction along X_W.
Eigen::Matrix3d R_WL() {
  Eigen::Matrix3d R;
  R << 0, -1, 0, -1, 0, 0, 0, 0, -1;
  return R;
}

}  // namespace

Eigen::Vector3d ReferenceNormal(const Eigen::Vector3d& gravity_B, const Eigen::Matrix3d& R_BC) {
  return R_BC.transpose() * -gravity_B;
}

std::size_t ResolveByGravity(const std::array<pad::CirclePose, 2>& poses, const Eigen::Vector3d& z_C) {
  return models::AngleBetween(poses[0].n_C, z_C) <= models::AngleBetween(poses[1].n_C, z_C) ? 0 : 1;
}

double WrongBranchProbability(const std::array<pad::CirclePose, 2>& poses, const Eigen::Vector3d& z_C,
                              double reference_sigma) {
  const double angle1 = models::AngleBetween(poses[0].n_C, z_C), angle2 = models::AngleBetween(poses[1].n_C, z_C);
  const double log_ratio = 0.5 * std::abs(angle2 * angle2 - angle1 * angle1) / (reference_sigma * reference_sigma);
  return 1.0 / (1.0 + std::exp(log_ratio));
}

double CameraYaw(double stroke_angle, const Eigen::Matrix3d& R_BC) {
  const Eigen::Vector3d forward = R_WL() * R_BC.transpose().col(0);
  const double body_from_camera = std::atan2(forward.y(), forward.x());
  return models::WrapToHalfPi(stroke_angle + models::kPi / 2.0 + body_from_camera) - body_from_camera;
}

Eigen::Matrix3d CameraRotation(const Eigen::Vector3d& n_C, double psi_C) {
  const Eigen::Matrix3d R_LC = models::ShortestRotation(n_C, -Eigen::Vector3d::UnitZ());
  return Eigen::AngleAxisd(psi_C, Eigen::Vector3d::UnitZ()).toRotationMatrix() * R_WL() * R_LC;
}

Eigen::Isometry3d BodyPose(const Eigen::Matrix3d& R_WC, const Eigen::Vector3d& p_CW, const Eigen::Isometry3d& X_BC) {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.linear() = R_WC * X_BC.linear().transpose();                                   // Eq. 17
  X_WB.translation() = -X_WB.linear() * (X_BC.linear() * p_CW + X_BC.translation());  // Eq. 18
  return X_WB;
}

}  // namespace touchdown::estimator::paper
