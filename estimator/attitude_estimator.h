#pragma once

#include <Eigen/Core>
#include <deque>

#include "models/angles.h"
#include "models/signals.h"

namespace touchdown::estimator {

struct AttitudeEstimatorConfig {
  double accelerometer_time_constant_s = 2.0;  ///< Longer trusts the gyro longer; shorter follows tilt of thrust.
  double gyro_bias_time_constant_s = 20.0;     ///< How fast the gyro's bias is learned from the accelerometer.
  double yaw_time_constant_s = 0.3;            ///< How fast yaw follows vision.
  double history_s = 0.5;                      ///< How late a camera frame may come.
};

/// Roll and pitch from the IMU alone (a complementary filter on the rotation group, Mahony et al. 2008), and yaw from
/// vision, carried on by the gyro between frames (Sec. V). Keeps a short history, since frames arrive late.
class AttitudeEstimator {
 public:
  /// `R_BU` is the calibrated mounting of the IMU.
  AttitudeEstimator(const AttitudeEstimatorConfig& config, const models::TimeBase& time, const Eigen::Matrix3d& R_BU);

  /// Takes the next sample. The first one sets roll and pitch from the accelerometer and yaw to 0; while `at_rest` (the
  /// vehicle knows that it stands on the ground, motors off) the gyro's bias and the tilt are averaged fast.
  void Update(const models::ImuSample& imu, bool at_rest);

  /// Corrects yaw by vision's yaw at an earlier instant, modulo 180 degrees (Sec. IV-C.3). Ignored when older than the
  /// history.
  void CorrectYaw(models::Tick mid_exposure, double yaw);

  models::TaitBryan attitude() const;
  /// Body rate, rad/s, less the estimated bias.
  const Eigen::Vector3d& w_WB_B() const { return w_WB_B_; }

  /// Unit vector pointing down, in B at `tick`: the newest sample's not after it, or the oldest one kept.
  Eigen::Vector3d GravityAt(models::Tick tick) const;
};

}  // namespace touchdown::estimator
