#pragma once

#include <Eigen/Core>
#include <deque>
#include <optional>

#include "models/angles.h"
#include "models/describe.h"
#include "models/signals.h"

namespace touchdown::estimator {

/// The two time constants hold once the filter has settled. Until then its gains are those of a Kalman filter that
/// starts from the two sigmas.
struct AttitudeEstimatorConfig {
  double accelerometer_time_constant_s = 10.0;
  double gyro_bias_time_constant_s = 40.0;
  double initial_tilt_sigma_deg = 1.1459155902616465;
  double initial_gyro_bias_sigma_deg_s = 0.49847328176381617;
  double level_ground_tolerance_deg = 4.010704565915763;
  double acceleration_tolerance = 0.25;
  double yaw_time_constant_s = 0.5;
  double yaw_bias_time_constant_s = 20.0;
  double history_s = 0.5;

  /// Throws InputError for a value out of its range (see Describe), or when the bias is learned too fast to be stable.
  void Validate() const;
};

void Describe(models::ConfigVisitor& v, AttitudeEstimatorConfig& config);

/// Roll and pitch from the IMU alone (a complementary filter on the rotation group, Mahony et al. 2008), and yaw from
/// vision, carried on by the gyro between frames (Sec. V). Keeps a short history, since frames arrive late.
class AttitudeEstimator {
 public:
  /// `R_BU` is the calibrated mounting of the IMU.
  AttitudeEstimator(const AttitudeEstimatorConfig& config, const models::TimeBase& time, const Eigen::Matrix3d& R_BU);

  /// Takes the next sample, a mean since the one before. The first one sets roll and pitch from the accelerometer and
  /// yaw to 0; samples before it with a specific force below 0.1 g, as in free fall, show no down and give their rate
  /// alone. While `at_rest` (the vehicle knows that it stands on the ground, motors off) the gyro's bias is
  /// averaged, and the accelerometer's as well if the ground may be level.
  void Update(const models::ImuSample& imu, bool at_rest);

  /// Corrects yaw by vision's yaw at an earlier instant, modulo 180 degrees (Sec. IV-C.3). The first correction sets
  /// it. Ignored when older than the history.
  void CorrectYaw(models::Tick mid_exposure, double yaw);

  models::TaitBryan attitude() const;
  /// Body rate, rad/s, less the estimated bias.
  const Eigen::Vector3d& w_WB_B() const { return w_WB_B_; }
  /// Estimated bias of the gyro, in B, rad/s.
  const Eigen::Vector3d& gyro_bias_B() const { return gyro_bias_B_; }

  /// Estimated bias of the accelerometer, in B, m/s^2.
  const Eigen::Vector3d& accelerometer_bias_B() const { return accelerometer_bias_B_; }
  /// Variance of the tilt about each horizontal axis that the filter claims, rad^2.
  double tilt_variance() const { return covariance_(0, 0); }

  /// Unit vector pointing down, in B at `tick`: the newest sample's not after it, or the oldest one kept. Before the
  /// first sample: of a level body.
  Eigen::Vector3d GravityAt(models::Tick tick) const;

 private:
  /// W turned about Z by yaw_WG_ gives G, in which the gyro integrates: a correction of yaw leaves the history as it
  /// is.
  struct Entry {
    models::Tick tick = 0;
    Eigen::Matrix3d R_GB = Eigen::Matrix3d::Identity();
  };
  void Start(const Eigen::Vector3d& f_B);
  void AverageAtRest(const Eigen::Vector3d& f_B, const Eigen::Vector3d& w_B, double dt_s);
  void Turn(const Eigen::Vector3d& w_WB_B, double dt_s);
  void CorrectTilt(const Eigen::Vector3d& f_B, double dt_s, bool at_rest);
  /// Kalman gains of (tilt, gyro bias) on an error of tilt, after a step of their covariance.
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
  Eigen::Vector3d accelerometer_bias_B_ = Eigen::Vector3d::Zero();  ///< As a level ground shows it.
  Eigen::Matrix2d covariance_;  ///< Of (tilt about a horizontal axis, gyro bias about it).
  double age_s_ = 0.0;          ///< Since the first sample.
  double rest_s_ = 0.0;         ///< Spent at rest.
  std::optional<models::Tick> yaw_corrected_;
};

}  // namespace touchdown::estimator
