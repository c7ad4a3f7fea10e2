#include "controller/attitude_controller.h"

#include <algorithm>
#include <cmath>

namespace touchdown::controller {

void Describe(models::ConfigVisitor& v, AttitudeControllerConfig& c) {
  using namespace models;
  v.Number({"roll_pitch_angle_gain_1_s", "Commanded rate per roll or pitch error. Higher is stiffer and less damped."},
           c.roll_pitch_angle_gain_1_s, kPerSecond, kNotNegative);
  v.Number({"roll_pitch_rate_gain_1_s",
            "Commanded angular acceleration per roll or pitch rate error. Higher damps more and passes more noise."},
           c.roll_pitch_rate_gain_1_s, kPerSecond, kNotNegative);
  v.Number({"roll_pitch_rate_integral_gain_1_s2",
            "Integral gain on the roll and pitch rate errors. It compensates a constant torque, such as that of an "
            "off-center load. "
            "Higher adapts faster and overshoots more."},
           c.roll_pitch_rate_integral_gain_1_s2, kPerSecond2, kNotNegative);
  v.Number({"roll_pitch_rate_derivative_gain",
            "Derivative gain on the roll and pitch rates. It compensates the rotor lag. Higher damps "
            "more and passes more noise."},
           c.roll_pitch_rate_derivative_gain, kNoUnit, kNotNegative);
  v.Number({"derivative_cutoff_hz",
            "Cutoff of the low-pass filter before the derivative. Lower passes less noise and adds delay."},
           c.derivative_cutoff_hz, kHertz, kPositive);
  v.Number({"max_roll_pitch_rate_deg_s", "Limit of the commanded roll and pitch rates."}, c.max_roll_pitch_rate_deg_s,
           kDegreePerSecond, kPositive);
  v.Number({"max_roll_pitch_integral_rad_s2",
            "Limit of the integral term of roll and pitch. Larger compensates larger constant torques."},
           c.max_roll_pitch_integral_rad_s2, kRadianPerSecond2, kPositive);
  v.Number({"yaw_angle_gain_1_s", "Commanded rate per yaw error. Higher is stiffer and less damped."},
           c.yaw_angle_gain_1_s, kPerSecond, kNotNegative);
  v.Number({"yaw_rate_gain_1_s",
            "Commanded angular acceleration per yaw rate error. Higher damps more and passes more noise."},
           c.yaw_rate_gain_1_s, kPerSecond, kNotNegative);
  v.Number({"yaw_rate_integral_gain_1_s2",
            "Integral gain on the yaw rate error. It compensates a constant torque. Higher adapts faster and "
            "overshoots more."},
           c.yaw_rate_integral_gain_1_s2, kPerSecond2, kNotNegative);
  v.Number({"max_yaw_rate_deg_s", "Limit of the commanded yaw rate."}, c.max_yaw_rate_deg_s, kDegreePerSecond,
           kPositive);
  v.Number(
      {"max_yaw_integral_rad_s2", "Limit of the integral term of yaw. Larger compensates larger constant torques."},
      c.max_yaw_integral_rad_s2, kRadianPerSecond2, kPositive);
}

void AttitudeControllerConfig::Validate() const { models::ValidateConfig(*this); }

AttitudeController::AttitudeController(const AttitudeControllerConfig& config, const models::Vehicle& vehicle,
                                       double period_s)
    : config_(config),
      inertia_kg_m2_(vehicle.inertia_kg_m2),
      period_s_(period_s),
      rate_gain_(config.roll_pitch_rate_gain_1_s, config.roll_pitch_rate_gain_1_s, config.yaw_rate_gain_1_s),
      integral_gain_(config.roll_pitch_rate_integral_gain_1_s2, config.roll_pitch_rate_integral_gain_1_s2,
                     config.yaw_rate_integral_gain_1_s2),
      max_integral_(config.max_roll_pitch_integral_rad_s2, config.max_roll_pitch_integral_rad_s2,
                    config.max_yaw_integral_rad_s2) {
  config.Validate();
}

Eigen::Vector3d AttitudeController::RateSetPoint(const models::TaitBryan& set_point,
                                                 const models::TaitBryan& attitude) const {
  const double tilt_limit = models::DegToRad(config_.max_roll_pitch_rate_deg_s);
  const double yaw_limit = models::DegToRad(config_.max_yaw_rate_deg_s);
  const double roll_rate = std::clamp(
      config_.roll_pitch_angle_gain_1_s * models::WrapToPi(set_point.roll - attitude.roll), -tilt_limit, tilt_limit);
  const double pitch_rate =
      std::clamp(config_.roll_pitch_angle_gain_1_s * (set_point.pitch - attitude.pitch), -tilt_limit, tilt_limit);
  const double yaw_rate =
      std::clamp(config_.yaw_angle_gain_1_s * models::WrapToPi(set_point.yaw - attitude.yaw), -yaw_limit, yaw_limit);
  const double sin_roll = std::sin(attitude.roll), cos_roll = std::cos(attitude.roll);
  const double sin_pitch = std::sin(attitude.pitch), cos_pitch = std::cos(attitude.pitch);
  return {roll_rate - sin_pitch * yaw_rate, cos_roll * pitch_rate + sin_roll * cos_pitch * yaw_rate,
          -sin_roll * pitch_rate + cos_roll * cos_pitch * yaw_rate};
}

Eigen::Vector3d AttitudeController::FilteredAcceleration(const Eigen::Vector3d& w_WB_B) {
  if (!has_rate_) filtered_rate_ = w_WB_B;
  has_rate_ = true;
  const double fraction = 1.0 - std::exp(-2.0 * models::kPi * config_.derivative_cutoff_hz * period_s_);
  const Eigen::Vector3d change = fraction * (w_WB_B - filtered_rate_);
  filtered_rate_ += change;
  return change / period_s_;
}

Eigen::Vector3d AttitudeController::Torque(const models::TaitBryan& set_point, const models::TaitBryan& attitude,
                                           const Eigen::Vector3d& w_WB_B) {
  const double derivative_gain = config_.roll_pitch_rate_derivative_gain;
  const Eigen::Vector3d damping =
      Eigen::Vector3d(derivative_gain, derivative_gain, 0.0).cwiseProduct(FilteredAcceleration(w_WB_B));
  rate_error_ = RateSetPoint(set_point, attitude) - w_WB_B;
  const Eigen::Vector3d acceleration = rate_gain_.cwiseProduct(rate_error_) + integral_ - damping;
  requested_torque_ =
      inertia_kg_m2_.cwiseProduct(acceleration) + w_WB_B.cross(Eigen::Vector3d(inertia_kg_m2_.cwiseProduct(w_WB_B)));
  return requested_torque_;
}

void AttitudeController::Integrate(const Eigen::Vector3d& achieved_torque_n_m) {
  constexpr double kTolerance_n_m = 1e-6;
  for (int axis = 0; axis < 3; ++axis) {
    const double missing = requested_torque_[axis] - achieved_torque_n_m[axis];
    if (std::abs(missing) > kTolerance_n_m && missing * rate_error_[axis] > 0.0) continue;
    integral_[axis] = std::clamp(integral_[axis] + integral_gain_[axis] * rate_error_[axis] * period_s_,
                                 -max_integral_[axis], max_integral_[axis]);
  }
}

void AttitudeController::Reset() {
  integral_.setZero();
  has_rate_ = false;
}

}  // namespace touchdown::controller
