#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>

#include "models/signals.h"

namespace touchdown::estimator::calibration {

/// What samples must be like for the mounting to be read from them.
struct ImuMountingConfig {
  std::size_t fewest_samples = 100;
  /// Most 1-sigma scatter of the specific force along an axis, m/s^2: a vehicle at rest, motors off, has that of its
  /// accelerometer's noise, some hundredths.
  double most_scatter_m_s2 = 0.3;
  double most_turn_rad_s = 0.1;          ///< Most mean rate of turn: a gyro's bias, but no turning.
  double most_gravity_error_m_s2 = 1.0;  ///< How far from 9.81 m/s^2 the mean specific force may be.
};

/// How the IMU sits on the body, as gravity tells.
struct ImuMounting {
  Eigen::Matrix3d R_BU = Eigen::Matrix3d::Identity();
  /// 1-sigma of its roll and pitch by the samples' noise alone, rad. The accelerometer's bias, of which samples of one
  /// pose tell nothing, adds bias / 9.81 m/s^2 along each axis: 1.1 deg for 0.02 g.
  double noise_sigma_rad = 0.0;
  std::size_t samples = 0;
};

/// The IMU's mounting from samples taken while the vehicle stands on level ground (Sec. III-D): the shortest rotation
/// with g_B = R_BU g_U, where g_U is the mean specific force, normalized, and g_B = (0, 0, 1) as the paper has it: what
/// an accelerometer at rest measures points up. An IMU mounted upside down, for which there is no shortest rotation, is
/// turned about an axis across, which one is arbitrary.
///
/// A turn about Z_B leaves gravity where it is, so that the true R_BU may be Rz(any) times the one found; being the
/// shortest, that has next to none. The IMU's position is not found: the paper takes U's origin to be B's.
///
/// Throws InputError for too few samples, for samples of a vehicle that is shaken or turned, and where the mean is not
/// that of gravity or a number is not finite.
ImuMounting FindImuMounting(std::span<const models::ImuSample> samples, const ImuMountingConfig& config = {});

}  // namespace touchdown::estimator::calibration
