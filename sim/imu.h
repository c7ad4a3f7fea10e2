#pragma once

#include <cstdint>
#include <optional>

#include "models/signals.h"
#include "sim/true_state.h"

namespace touchdown::sim {

/// Noise of EuRoC to PX4's Gazebo model, turn-on bias of RotorS' ADIS16448, ranges of the paper's pxIMU (Sec. III-A).
struct ImuConfig {
  int rate_hz = 200;
  double gyro_noise_rad_s_sqrt_hz = 1.7e-4;
  double accelerometer_noise_m_s2_sqrt_hz = 2.0e-3;
  double gyro_bias_sigma_rad_s = 0.0087;        ///< Turn-on, per axis: 0.5 deg/s.
  double accelerometer_bias_sigma_m_s2 = 0.196; ///< Turn-on, per axis: 0.02 g.
  double gyro_range_rad_s = 8.7266;             ///< +-500 deg/s.
  double accelerometer_range_m_s2 = 58.86;      ///< +-6 g.

  void Validate(const models::TimeBase& time) const;
};

class Imu {
 public:
  Imu(const ImuConfig& config, const Eigen::Isometry3d& X_BU, const models::TimeBase& time, std::uint64_t seed);

  /// Call once a tick; returns a sample on the ticks of its rate.
  std::optional<models::ImuSample> Sample(const TrueState& truth);
};

}  // namespace touchdown::sim
