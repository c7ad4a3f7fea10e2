#pragma once

#include <Eigen/Core>
#include <numbers>

namespace touchdown::models {

inline constexpr double kPi = std::numbers::pi;

constexpr double DegToRad(double deg) { return deg * (kPi / 180.0); }
constexpr double RadToDeg(double rad) { return rad * (180.0 / kPi); }

/// Tait-Bryan angles of a body in the world, radians: R_WB = Rz(yaw) Ry(pitch) Rx(roll). The paper's phi,
/// theta and psi (Sec. III-D, Eq. 12).
struct TaitBryan {
  double roll = 0.0;   ///< (-pi, pi], about X forward; positive lowers the right side.
  double pitch = 0.0;  ///< [-pi/2, pi/2], about Y left; positive lowers the nose.
  double yaw = 0.0;    ///< (-pi, pi], about Z up; positive turns left.
};

/// Tait-Bryan angles in degrees, for configurations, which store numbers in the unit of their key.
struct TaitBryanDeg {
  double roll = 0.0;
  double pitch = 0.0;
  double yaw = 0.0;
};
constexpr TaitBryan ToRadians(const TaitBryanDeg& angles) {
  return {.roll = DegToRad(angles.roll), .pitch = DegToRad(angles.pitch), .yaw = DegToRad(angles.yaw)};
}
constexpr TaitBryanDeg ToDegrees(const TaitBryan& angles) {
  return {.roll = RadToDeg(angles.roll), .pitch = RadToDeg(angles.pitch), .yaw = RadToDeg(angles.yaw)};
}

/// Rotation R_WB of the given angles.
Eigen::Matrix3d RotationFromTaitBryan(const TaitBryan& angles);

/// Angles of R_WB. At pitch = +-90 deg, where roll and yaw rotate about the same axis, roll is set to 0.
TaitBryan TaitBryanFromRotation(const Eigen::Matrix3d& R_WB);

/// Equivalent of an angle modulo 2 pi, in (-pi, pi].
double WrapToPi(double angle);

/// Equivalent of an angle modulo pi, in (-pi/2, pi/2]: the observable yaw of an H, which looks the same rotated by
/// 180 degrees (Sec. IV-C.3).
double WrapToHalfPi(double angle);

/// Shortest rotation R with R * from = to, for unit vectors. For opposite vectors, whose rotation axis is undefined, it
/// uses an arbitrary axis perpendicular to `from`.
Eigen::Matrix3d ShortestRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Angle between two nonzero vectors, in [0, pi]; accurate for small angles too.
double AngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Rotation by |phi| radians about phi: exp([phi]x).
Eigen::Matrix3d RotationExp(const Eigen::Vector3d& phi);

/// Inverse of RotationExp: rotation vector of R, with a norm in [0, pi].
Eigen::Vector3d RotationLog(const Eigen::Matrix3d& R);

}  // namespace touchdown::models
