#include "estimator/attitude_estimator.h"

#include <algorithm>
#include <cmath>

#include "models/error.h"

namespace touchdown::estimator {
namespace {

using models::kGravity_m_s2;

/// Noise density of the accelerometer's tilt in flight, from the vehicle's own acceleration of about 0.3 m/s^2 over
/// 0.7 s.
constexpr double kManeuverDensity_rad2_s = 0.0015;
/// Noise density of the accelerometer's tilt at rest, from accelerometer noise of 6.4e-3 m/s^2/sqrt(Hz).
constexpr double kRestDensity_rad2_s = 4e-7;
/// Duration after the first sample over which the accelerometer's tilt is averaged. Averaging removes the noise; the
/// vehicle's own acceleration changes slowly and is covered by initial_tilt_sigma.
constexpr double kSettling_s = 0.1;
/// Gyro noise density squared (8.7e-4 rad/s/sqrt(Hz)).
constexpr double kGyroDensity_rad2_s = 8e-7;
/// Smallest specific force from which the direction of gravity is computed.
constexpr double kMinForce_m_s2 = 0.1 * kGravity_m_s2;

}  // namespace

void Describe(models::ConfigVisitor& v, AttitudeEstimatorConfig& c) {
  using namespace models;
  v.Number(
      {"accelerometer_time_constant_s",
       "Time constant with which the tilt follows the accelerometer. Longer relies on the gyro for longer; shorter "
       "follows the vehicle's own acceleration more."},
      c.accelerometer_time_constant_s, kSecond, kPositiveTime);
  v.Number(
      {"gyro_bias_time_constant_s",
       "Time constant of the gyro bias, at least twice accelerometer_time_constant_s. Longer is smoother and slower."},
      c.gyro_bias_time_constant_s, kSecond, kPositiveTime);
  v.Number({"initial_tilt_sigma_deg",
            "Standard deviation of the roll and pitch that the first 0.1 s of samples yield. Larger lets later samples "
            "correct them faster."},
           c.initial_tilt_sigma_deg, kDegree, kPositive);
  v.Number({"initial_gyro_bias_sigma_deg_s",
            "Standard deviation of the gyro bias at the start. Larger lets the first samples change the bias faster."},
           c.initial_gyro_bias_sigma_deg_s, kDegreePerSecond, kPositive);
  v.Number({"level_ground_tolerance_deg",
            "Largest tilt of the accelerometer at rest for which the ground is assumed level (the second assumption of "
            "Sec. IV-C.2) and the tilt is attributed to the accelerometer bias. Larger accepts steeper ground as "
            "level; 0 disables the assumption, for takeoffs from slopes."},
           c.level_ground_tolerance_deg, kDegree, Between(0.0, 90.0));
  v.Number({"acceleration_tolerance",
            "Relative deviation of the specific force from gravity above which the accelerometer does not correct the "
            "tilt. Larger corrects the tilt during stronger accelerations too."},
           c.acceleration_tolerance, kNoUnit, kPositive);
  v.Number({"yaw_time_constant_s", "Time constant with which yaw follows vision. Longer is smoother and slower."},
           c.yaw_time_constant_s, kSecond, kPositiveTime);
  v.Number(
      {"yaw_bias_time_constant_s",
       "Time constant with which vision's yaw corrects the bias of the gyro's Z axis. Longer is smoother and slower."},
      c.yaw_bias_time_constant_s, kSecond, kPositiveTime);
  v.Number({"history_s",
            "Length of the attitude history. A frame that is older than this when it arrives does not correct the yaw. "
            "Larger accepts older frames and needs more memory."},
           c.history_s, kSecond, PositiveUpTo(10.0));
  v.Check("", [&c] {
    if (c.gyro_bias_time_constant_s < 2.0 * c.accelerometer_time_constant_s) {
      throw InputError("gyro_bias_time_constant_s must be at least twice accelerometer_time_constant_s");
    }
  });
}

void AttitudeEstimatorConfig::Validate() const { models::ValidateConfig(*this); }

AttitudeEstimator::AttitudeEstimator(const AttitudeEstimatorConfig& config, const models::TimeBase& time,
                                     const Eigen::Matrix3d& R_BU)
    : config_(config), time_(time), R_BU_(R_BU) {
  config.Validate();
  const double tilt = models::DegToRad(config.initial_tilt_sigma_deg);
  const double bias = models::DegToRad(config.initial_gyro_bias_sigma_deg_s);
  covariance_ = Eigen::Vector2d(tilt * tilt, bias * bias).asDiagonal();
}

void AttitudeEstimator::Update(const models::ImuSample& imu, bool at_rest) {
  const Eigen::Vector3d measured_f_B = R_BU_ * imu.specific_force_U;
  const Eigen::Vector3d w_B = R_BU_ * imu.w_WU_U;
  if (history_.empty() && measured_f_B.norm() < kMinForce_m_s2) {
    w_WB_B_ = w_B;
    return;
  }
  if (history_.empty()) {
    Start(measured_f_B);
  } else {
    const double dt_s = time_.ToSeconds(imu.tick - history_.back().tick);
    age_s_ += dt_s;
    if (at_rest) AverageAtRest(measured_f_B, w_B, dt_s);
    Integrate(w_B - gyro_bias_B_, dt_s);
    CorrectTilt(measured_f_B - accelerometer_bias_B_, dt_s, at_rest);
  }
  w_WB_B_ = w_B - gyro_bias_B_;
  history_.push_back({imu.tick, R_GB_});
  while (imu.tick - history_.front().tick > time_.FromSeconds(config_.history_s)) history_.pop_front();
}

void AttitudeEstimator::Start(const Eigen::Vector3d& f_B) {
  models::TaitBryan level;
  level.roll = std::atan2(f_B.y(), f_B.z());
  level.pitch = std::atan2(-f_B.x(), std::hypot(f_B.y(), f_B.z()));
  R_GB_ = models::RotationFromTaitBryan(level);
}

void AttitudeEstimator::AverageAtRest(const Eigen::Vector3d& f_B, const Eigen::Vector3d& w_B, double dt_s) {
  rest_s_ += dt_s;
  gyro_bias_B_ += dt_s / rest_s_ * (w_B - gyro_bias_B_);
  covariance_(0, 1) = covariance_(1, 0) = 0.0;
  covariance_(1, 1) = std::min(covariance_(1, 1), kGyroDensity_rad2_s / rest_s_);

  rest_force_B_ += dt_s / rest_s_ * (f_B - rest_force_B_);
  const Eigen::Vector3d up_B = Eigen::Vector3d::UnitZ();
  const double tilt = std::atan2(rest_force_B_.cross(up_B).norm(), rest_force_B_.dot(up_B));
  const bool level = tilt < models::DegToRad(config_.level_ground_tolerance_deg);
  accelerometer_bias_B_ = level ? Eigen::Vector3d(rest_force_B_ - kGravity_m_s2 * up_B) : Eigen::Vector3d::Zero();
}

void AttitudeEstimator::Integrate(const Eigen::Vector3d& w_WB_B, double dt_s) {
  R_GB_ = R_GB_ * models::RotationExp(w_WB_B * dt_s);
  R_GB_ = Eigen::Quaterniond(R_GB_).normalized().toRotationMatrix();
}

void AttitudeEstimator::CorrectTilt(const Eigen::Vector3d& f_B, double dt_s, bool at_rest) {
  const Eigen::Vector2d gain = Gain(dt_s, AccelerometerWeight(f_B), at_rest);
  const Eigen::Vector3d up_B = R_GB_.transpose().col(2);
  const Eigen::Vector3d error = f_B.normalized().cross(up_B);
  R_GB_ = R_GB_ * models::RotationExp(gain[0] * error);
  gyro_bias_B_ += gain[1] * error;
}

Eigen::Vector2d AttitudeEstimator::Gain(double dt_s, double weight, bool at_rest) {
  const double tilt_gain = 1.0 / config_.accelerometer_time_constant_s;
  const double bias_gain = tilt_gain / config_.gyro_bias_time_constant_s;
  Eigen::Matrix2d F, Q;
  F << 1.0, -dt_s, 0.0, 1.0;
  Q << tilt_gain * tilt_gain - 2.0 * bias_gain, 0.0, 0.0, bias_gain * bias_gain;
  covariance_ = F * covariance_ * F.transpose() + kManeuverDensity_rad2_s * dt_s * Q;
  if (weight <= 0.0 || dt_s <= 0.0) return Eigen::Vector2d::Zero();

  if (age_s_ < kSettling_s) return {dt_s / age_s_, 0.0};
  const double density = at_rest ? kRestDensity_rad2_s : kManeuverDensity_rad2_s;
  const Eigen::Vector2d gain = covariance_.col(0) / (covariance_(0, 0) + density / (weight * dt_s));
  covariance_ -= gain * covariance_.row(0).eval();
  return gain;
}

double AttitudeEstimator::AccelerometerWeight(const Eigen::Vector3d& f_B) const {
  const double excess = (f_B.norm() / kGravity_m_s2 - 1.0) / config_.acceleration_tolerance;
  return std::max(0.0, 1.0 - excess * excess);
}

void AttitudeEstimator::CorrectYaw(models::Tick mid_exposure, double yaw) {
  if (history_.empty() || mid_exposure < history_.front().tick) return;
  if (yaw_corrected_.has_value() && mid_exposure <= *yaw_corrected_) return;
  const double yaw_then = yaw_WG_ + models::TaitBryanFromRotation(EntryAt(mid_exposure).R_GB).yaw;
  const double error = models::WrapToHalfPi(yaw - yaw_then);
  if (!yaw_corrected_.has_value()) {
    yaw_WG_ += error;
  } else {
    constexpr double kLongestStep_s = 0.1;
    const double dt_s = std::min(kLongestStep_s, time_.ToSeconds(mid_exposure - *yaw_corrected_));
    const double gain = 1.0 - std::exp(-dt_s / config_.yaw_time_constant_s);
    yaw_WG_ += gain * error;
    gyro_bias_B_.z() -= gain * error / config_.yaw_bias_time_constant_s;
  }
  yaw_corrected_ = mid_exposure;
}

models::TaitBryan AttitudeEstimator::attitude() const {
  models::TaitBryan attitude = models::TaitBryanFromRotation(R_GB_);
  attitude.yaw = models::WrapToPi(attitude.yaw + yaw_WG_);
  return attitude;
}

Eigen::Vector3d AttitudeEstimator::GravityAt(models::Tick tick) const {
  if (history_.empty()) return -Eigen::Vector3d::UnitZ();
  return -EntryAt(tick).R_GB.transpose().col(2);
}

const AttitudeEstimator::Entry& AttitudeEstimator::EntryAt(models::Tick tick) const {
  const auto after = std::upper_bound(history_.begin(), history_.end(), tick,
                                      [](models::Tick t, const Entry& entry) { return t < entry.tick; });
  return after == history_.begin() ? history_.front() : *(after - 1);
}

}  // namespace touchdown::estimator
