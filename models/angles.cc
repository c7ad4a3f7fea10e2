#include "models/angles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace touchdown::models {

Eigen::Matrix3d RotationFromTaitBryan(const TaitBryan& angles) {
  return (Eigen::AngleAxisd(angles.yaw, Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(angles.pitch, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(angles.roll, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

TaitBryan TaitBryanFromRotation(const Eigen::Matrix3d& R_WB) {
  TaitBryan angles;
  const double cos_pitch = std::hypot(R_WB(0, 0), R_WB(1, 0));
  angles.pitch = std::atan2(-R_WB(2, 0), cos_pitch);
  constexpr double kGimbalLock = 1e-9;
  if (cos_pitch < kGimbalLock) {
    angles.yaw = std::atan2(-R_WB(0, 1), R_WB(1, 1));
  } else {
    angles.roll = std::atan2(R_WB(2, 1), R_WB(2, 2));
    angles.yaw = std::atan2(R_WB(1, 0), R_WB(0, 0));
  }
  return angles;
}

double WrapToPi(double angle) {
  const double wrapped = std::remainder(angle, 2.0 * kPi);
  return wrapped <= -kPi ? wrapped + 2.0 * kPi : wrapped;
}

double WrapToHalfPi(double angle) {
  const double wrapped = std::remainder(angle, kPi);
  return wrapped <= -kPi / 2.0 ? wrapped + kPi : wrapped;
}

Eigen::Matrix3d ShortestRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
}

double AngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

Eigen::Matrix3d RotationExp(const Eigen::Vector3d& phi) {
  const double angle = phi.norm();
  if (angle == 0.0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, phi / angle).toRotationMatrix();
}

Eigen::Vector3d RotationLog(const Eigen::Matrix3d& R) {
  const Eigen::AngleAxisd angle_axis(R);
  return angle_axis.angle() * angle_axis.axis();
}

}  // namespace touchdown::models
