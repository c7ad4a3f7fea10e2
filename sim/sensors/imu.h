#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <optional>

#include "models/describe.h"
#include "models/random_stream.h"
#include "models/signals.h"
#include "sim/dynamics/ground_tilt.h"
#include "sim/dynamics/true_state.h"

namespace touchdown::sim {

/// Parameters of the IMU. By default, the noise densities are those of EuRoC and of PX4's Gazebo model, the turn-on
/// bias is that of the ADIS16448 in RotorS, and the ranges are those of the paper's pxIMU (Sec. III-A).
struct ImuConfig {
  int rate_hz = 200;
  double gyro_noise_rad_s_sqrt_hz = 1.7e-4;
  double accelerometer_noise_m_s2_sqrt_hz = 2.0e-3;
  double gyro_bias_sigma_deg_s = 0.5;
  double accelerometer_bias_sigma_m_s2 = 0.196;  // 0.02 g.
  double gyro_range_deg_s = 500.0;
  double accelerometer_range_m_s2 = 58.86;  // 6 g.

  /// Throws InputError for a value out of its range (see Describe), or when the rate does not divide `time`'s.
  void Validate(const models::TimeBase& time) const;
};

void Describe(models::ConfigVisitor& v, ImuConfig& config);

/// Accelerometer and gyro at U. A sample is the mean of specific force and body rate over the ticks since the last
/// sample, plus white noise with a standard deviation of density x sqrt(rate), plus a bias drawn once, saturated at the
/// range. The mean acts like the low-pass filter of a real IMU: it damps rotor vibration instead of only aliasing it,
/// and the sum of the samples is the change of velocity.
class Imu {
 public:
  /// Draws the bias from the stream "imu.bias"; noise comes from "imu.noise". `X_BU` is the true mounting.
  Imu(const ImuConfig& config, const Eigen::Isometry3d& X_BU, const models::TimeBase& time, std::uint64_t seed,
      const GroundTilt& ground = {});

  /// Call once per tick, in order; returns a sample on the ticks of its rate. The first tick may be negative. The
  /// sample at tick 0 is instantaneous, without acceleration.
  std::optional<models::ImuSample> Sample(const TrueState& truth);

 private:
  void Accumulate(const TrueState& truth);

  ImuConfig config_;
  Eigen::Isometry3d X_BU_;
  Eigen::Vector3d gravity_W_;
  double tick_s_;
  models::Tick period_;
  models::RandomStream noise_;
  Eigen::Vector3d gyro_bias_;
  Eigen::Vector3d accelerometer_bias_;
  Eigen::Vector3d specific_force_sum_ = Eigen::Vector3d::Zero();  ///< In U.
  Eigen::Vector3d rate_sum_ = Eigen::Vector3d::Zero();            ///< In U.
  int count_ = 0;
};

}  // namespace touchdown::sim
