#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>

#include "models/signals.h"

namespace touchdown::estimator::calibration {

/// Limits that the samples must satisfy.
struct ImuMountingConfig {
  std::size_t min_samples = 100;
  /// Largest standard deviation of the specific force along an axis, m/s^2. At rest, motors off, the scatter is
  /// accelerometer noise of a few hundredths.
  double max_scatter_m_s2 = 0.3;
  double max_rate_rad_s = 0.1;          ///< Largest mean angular rate: allows a gyro bias, but no rotation.
  double max_gravity_error_m_s2 = 1.0;  ///< Largest deviation of the mean specific force from 9.81 m/s^2.
};

/// Orientation of the IMU in the body frame, estimated from gravity.
struct ImuMounting {
  Eigen::Matrix3d R_BU = Eigen::Matrix3d::Identity();
  /// Standard deviation of roll and pitch due to sample noise alone, rad. An accelerometer bias is not observable from
  /// one pose; it adds bias / 9.81 m/s^2 along each axis, 1.1 deg for 0.02 g.
  double noise_sigma_rad = 0.0;
  std::size_t samples = 0;  ///< Number of samples used.
};

/// Estimates the IMU's mounting from samples recorded while the vehicle stands on level ground (Sec. III-D).
///
/// R_BU is the shortest rotation with g_B = R_BU g_U, where g_U is the normalized mean specific force and
/// g_B = (0, 0, 1), as in the paper: an accelerometer at rest measures a vector that points up. For an IMU mounted
/// upside down the shortest rotation is not unique; the choice of its horizontal axis is arbitrary.
///
/// Gravity does not determine the rotation about Z_B: the true R_BU may be Rz(angle) times the result for any angle.
/// The shortest rotation has almost no rotation about Z_B. The IMU's position is not estimated: the paper assumes that
/// U and B have the same origin.
///
/// Throws InputError for too few samples, when the vehicle shakes or rotates, when the mean specific force is not that
/// of gravity, and when a value is not finite.
ImuMounting FindImuMounting(std::span<const models::ImuSample> samples, const ImuMountingConfig& config = {});

}  // namespace touchdown::estimator::calibration
