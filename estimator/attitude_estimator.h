#pragma once

#include <Eigen/Core>
#include <deque>
#include <optional>

#include "models/angles.h"
#include "models/describe.h"
#include "models/signals.h"

namespace touchdown::estimator {

/// Settings of AttitudeEstimator.
///
/// The accelerometer and gyro bias time constants apply once the filter has settled. Until then its gains are those of
/// a Kalman filter that starts from the two sigmas.
struct AttitudeEstimatorConfig {
  double accelerometer_time_constant_s = 10.0;
  double gyro_bias_time_constant_s = 40.0;
  double initial_tilt_sigma_deg = 1.15;
  double initial_gyro_bias_sigma_deg_s = 0.5;
  double level_ground_tolerance_deg = 4.0;
  double acceleration_tolerance = 0.25;
  double yaw_time_constant_s = 0.5;
  double yaw_bias_time_constant_s = 20.0;
  double history_s = 0.5;

  /// Throws InputError for a value out of its range (see Describe), or when gyro_bias_time_constant_s is too short for
  /// a stable filter.
  void Validate() const;
};

void Describe(models::ConfigVisitor& v, AttitudeEstimatorConfig& config);

/// Estimates the attitude: roll and pitch from the IMU alone with a complementary filter on the rotation group (Mahony
/// et al. 2008), yaw from vision, propagated by the gyro between frames (Sec. V). Keeps a short history, because frames
/// arrive late.
class AttitudeEstimator {
 public:
  /// `R_BU` is the calibrated orientation of the IMU in the body frame. Throws InputError for an invalid config.
  AttitudeEstimator(const AttitudeEstimatorConfig& config, const models::TimeBase& time, const Eigen::Matrix3d& R_BU);

  /// Adds the next IMU sample, the mean since the previous sample.
  ///
  /// The first sample with a specific force of at least 0.1 g sets roll and pitch from the accelerometer, and yaw to 0.
  /// Earlier samples, as in free fall, update only the body rate. While `at_rest` (on the ground, motors off) the gyro
  /// bias is averaged; the accelerometer bias is averaged too if the ground may be level.
  void Update(const models::ImuSample& imu, bool at_rest);

  /// Corrects yaw with vision's yaw at an earlier tick, rad, known modulo 180 degrees (Sec. IV-C.3). The first
  /// correction sets the yaw. A correction older than the history, or not newer than the previous one, is ignored.
  void CorrectYaw(models::Tick mid_exposure, double yaw);

  models::TaitBryan attitude() const;
  /// Body rate minus the estimated gyro bias, rad/s.
  const Eigen::Vector3d& w_WB_B() const { return w_WB_B_; }
  /// Estimated gyro bias in B, rad/s.
  const Eigen::Vector3d& gyro_bias_B() const { return gyro_bias_B_; }

  /// Estimated accelerometer bias in B, m/s^2.
  const Eigen::Vector3d& accelerometer_bias_B() const { return accelerometer_bias_B_; }
  /// Estimated variance of the tilt about each horizontal axis, rad^2.
  double tilt_variance() const { return covariance_(0, 0); }

  /// Unit vector pointing down, in B, from the newest sample at or before `tick`, or else from the oldest sample in the
  /// history. Before the first sample it is (0, 0, -1), as for a level body.
  Eigen::Vector3d GravityAt(models::Tick tick) const;

 private:
  /// Attitude at a sample, in frame G. The gyro is integrated in G, which is W rotated about Z by yaw_WG_, so that a
  /// yaw correction does not change the history.
  struct Entry {
    models::Tick tick = 0;
    Eigen::Matrix3d R_GB = Eigen::Matrix3d::Identity();
  };
  void Start(const Eigen::Vector3d& f_B);
  void AverageAtRest(const Eigen::Vector3d& f_B, const Eigen::Vector3d& w_B, double dt_s);
  void Integrate(const Eigen::Vector3d& w_WB_B, double dt_s);
  void CorrectTilt(const Eigen::Vector3d& f_B, double dt_s, bool at_rest);
  /// Propagates the covariance by `dt_s` and returns the Kalman gains of (tilt, gyro bias) for a tilt error.
  Eigen::Vector2d Gain(double dt_s, double weight, bool at_rest);
  double AccelerometerWeight(const Eigen::Vector3d& f_B) const;
  const Entry& EntryAt(models::Tick tick) const;

  AttitudeEstimatorConfig config_;
  models::TimeBase time_;
  Eigen::Matrix3d R_BU_;
  std::deque<Entry> history_;
  Eigen::Matrix3d R_GB_ = Eigen::Matrix3d::Identity();
  double yaw_WG_ = 0.0;
  Eigen::Vector3d w_WB_B_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d gyro_bias_B_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d rest_force_B_ = Eigen::Vector3d::Zero();          ///< Mean specific force at rest.
  Eigen::Vector3d accelerometer_bias_B_ = Eigen::Vector3d::Zero();  ///< Estimated on level ground.
  Eigen::Matrix2d covariance_;                 ///< State: tilt about a horizontal axis, gyro bias about it.
  double age_s_ = 0.0;                         ///< Time since the first sample.
  double rest_s_ = 0.0;                        ///< Time at rest.
  std::optional<models::Tick> yaw_corrected_;  ///< Mid-exposure of the newest yaw correction.
};

}  // namespace touchdown::estimator
