#include "controller/position_controller.h"

#include <algorithm>
#include <cmath>

namespace touchdown::controller {
namespace {

/// `v` with its horizontal part shortened to `length` if it is longer.
Eigen::Vector3d WithHorizontalLimit(Eigen::Vector3d v, double length) {
  const double norm = v.head<2>().norm();
  if (norm > length) v.head<2>() *= length / norm;
  return v;
}

}  // namespace

void Describe(models::ConfigVisitor& v, PositionControllerConfig& c) {
  using namespace models;
  constexpr double kMaxTilt_deg = 59.0;
  constexpr double kBelowGravity_m_s2 = 9.8;
  v.Number(
      {"xy_position_gain_1_s", "Commanded horizontal speed per position error. Higher is stiffer and less damped."},
      c.xy_position_gain_1_s, kPerSecond, kNotNegative);
  v.Number({"xy_velocity_gain_1_s",
            "Commanded horizontal acceleration per velocity error. Higher damps more and passes more noise."},
           c.xy_velocity_gain_1_s, kPerSecond, kNotNegative);
  v.Number({"xy_integral_gain_1_s2",
            "Integral gain on the horizontal velocity error. It compensates wind and a level error of the IMU. Higher "
            "adapts faster and overshoots more."},
           c.xy_integral_gain_1_s2, kPerSecond2, kNotNegative);
  v.Number({"z_position_gain_1_s", "Commanded vertical speed per height error. Higher is stiffer and less damped."},
           c.z_position_gain_1_s, kPerSecond, kNotNegative);
  v.Number({"z_velocity_gain_1_s",
            "Commanded vertical acceleration per velocity error. Higher damps more and passes more noise."},
           c.z_velocity_gain_1_s, kPerSecond, kNotNegative);
  v.Number({"z_integral_gain_1_s2",
            "Integral gain on the vertical velocity error. It compensates an error of mass or thrust. Higher adapts "
            "faster and overshoots more."},
           c.z_integral_gain_1_s2, kPerSecond2, kNotNegative);
  v.Number({"max_xy_speed_m_s", "Limit of the commanded horizontal speed. The set-point's own speed is added to it."},
           c.max_xy_speed_m_s, kMeterPerSecond, kPositive);
  v.Number({"max_z_speed_m_s", "Limit of the commanded vertical speed. The set-point's own speed is added to it."},
           c.max_z_speed_m_s, kMeterPerSecond, kPositive);
  v.Number({"max_tilt_deg", "Limit of the commanded tilt."}, c.max_tilt_deg, kDegree, PositiveUpTo(kMaxTilt_deg));
  v.Number({"max_z_acceleration_m_s2", "Limit of the commanded vertical acceleration. It must be below gravity."},
           c.max_z_acceleration_m_s2, kMeterPerSecond2, PositiveUpTo(kBelowGravity_m_s2));
  v.Number({"max_xy_integral_m_s2", "Limit of the horizontal integral term. Larger compensates stronger wind."},
           c.max_xy_integral_m_s2, kMeterPerSecond2, kPositive);
  v.Number({"max_z_integral_m_s2",
            "Limit of the vertical integral term. Larger compensates larger errors of mass or "
            "thrust."},
           c.max_z_integral_m_s2, kMeterPerSecond2, kPositive);
  v.Number({"max_integrated_error_m_s",
            "Limit of the velocity error that is integrated, which reduces the effect of a push. Larger adapts faster "
            "and overshoots more."},
           c.max_integrated_error_m_s, kMeterPerSecond, kPositive);
}

void PositionControllerConfig::Validate() const { models::ValidateConfig(*this); }

PositionController::PositionController(const PositionControllerConfig& config, const models::Vehicle& vehicle,
                                       double period_s)
    : config_(config),
      mass_kg_(vehicle.mass_kg),
      period_s_(period_s),
      position_gain_(config.xy_position_gain_1_s, config.xy_position_gain_1_s, config.z_position_gain_1_s),
      velocity_gain_(config.xy_velocity_gain_1_s, config.xy_velocity_gain_1_s, config.z_velocity_gain_1_s),
      integral_gain_(config.xy_integral_gain_1_s2, config.xy_integral_gain_1_s2, config.z_integral_gain_1_s2) {
  config.Validate();
}

PositionController::Demand PositionController::Update(const Target& target,
                                                      const models::VehicleEstimate::Motion& motion,
                                                      const models::TaitBryan& attitude) {
  const Eigen::Vector3d error = target.p_m - motion.p_WB;
  Eigen::Vector3d velocity = WithHorizontalLimit(position_gain_.cwiseProduct(error), config_.max_xy_speed_m_s);
  velocity.z() = std::clamp(velocity.z(), -config_.max_z_speed_m_s, config_.max_z_speed_m_s);
  velocity += target.v_m_s;

  velocity_error_ = velocity - motion.v_WB;
  const Eigen::Vector3d acceleration = velocity_gain_.cwiseProduct(velocity_error_) + integral_;
  const Eigen::Vector3d limited = Limited(acceleration);
  excess_ = acceleration - limited;
  const Demand demand = DemandFor(limited, attitude);
  requested_thrust_n_ = demand.thrust_n;
  return demand;
}

PositionController::Demand PositionController::Trimmed(const models::TaitBryan& attitude) const {
  return DemandFor(Limited(integral_), attitude);
}

Eigen::Vector3d PositionController::Limited(Eigen::Vector3d acceleration) const {
  acceleration.z() = std::clamp(acceleration.z(), -config_.max_z_acceleration_m_s2, config_.max_z_acceleration_m_s2);
  return WithHorizontalLimit(
      acceleration, std::tan(models::DegToRad(config_.max_tilt_deg)) * (models::kGravity_m_s2 + acceleration.z()));
}

PositionController::Demand PositionController::DemandFor(Eigen::Vector3d acceleration,
                                                         const models::TaitBryan& attitude) const {
  const double forward = std::cos(attitude.yaw) * acceleration.x() + std::sin(attitude.yaw) * acceleration.y();
  const double left = -std::sin(attitude.yaw) * acceleration.x() + std::cos(attitude.yaw) * acceleration.y();
  const double up = models::kGravity_m_s2 + acceleration.z();

  Demand demand;
  demand.pitch = std::atan2(forward, up);
  demand.roll = std::atan2(-left, std::hypot(forward, up));
  constexpr double kMinUprightness = 0.7;
  const double uprightness = std::max(kMinUprightness, std::cos(attitude.roll) * std::cos(attitude.pitch));
  demand.thrust_n = mass_kg_ * up / uprightness;
  return demand;
}

void PositionController::Integrate(double achieved_thrust_n) {
  const Eigen::Vector3d error = WithHorizontalLimit(velocity_error_, config_.max_integrated_error_m_s);
  const double z_error = std::clamp(error.z(), -config_.max_integrated_error_m_s, config_.max_integrated_error_m_s);
  constexpr double kTolerance_n = 1e-6;
  const double missing_n = requested_thrust_n_ - achieved_thrust_n;
  const bool thrust_short = std::abs(missing_n) > kTolerance_n && missing_n * z_error > 0.0;

  for (int axis = 0; axis < 2; ++axis) {
    if (excess_[axis] * error[axis] > 0.0) continue;
    integral_[axis] += integral_gain_[axis] * error[axis] * period_s_;
  }
  integral_ = WithHorizontalLimit(integral_, config_.max_xy_integral_m_s2);
  if (thrust_short || excess_.z() * z_error > 0.0) return;
  integral_.z() = std::clamp(integral_.z() + integral_gain_.z() * z_error * period_s_, -config_.max_z_integral_m_s2,
                             config_.max_z_integral_m_s2);
}

void PositionController::SetTrimFromStance(const models::TaitBryan& attitude) {
  const Eigen::Vector3d up_W = models::RotationFromTaitBryan(attitude).col(2);
  integral_.head<2>() = models::kGravity_m_s2 / up_W.z() * up_W.head<2>();
  integral_ = WithHorizontalLimit(integral_, config_.max_xy_integral_m_s2);
}

}  // namespace touchdown::controller
