#include "controller/position_controller.h"

#include <algorithm>
#include <cmath>

#include "controller/validate.h"
#include "models/error.h"

namespace touchdown::controller {
namespace {

/// `v` with its horizontal part shortened to `length` if it is longer.
Eigen::Vector3d WithHorizontalLimit(Eigen::Vector3d v, double length) {
  const double norm = v.head<2>().norm();
  if (norm > length) v.head<2>() *= length / norm;
  return v;
}

}  // namespace

void PositionControllerConfig::Validate() const {
  RequireNotNegative(xy_position_gain_1_s, "xy_position_gain");
  RequireNotNegative(xy_velocity_gain_1_s, "xy_velocity_gain");
  RequireNotNegative(xy_integral_gain_1_s2, "xy_integral_gain");
  RequireNotNegative(z_position_gain_1_s, "z_position_gain");
  RequireNotNegative(z_velocity_gain_1_s, "z_velocity_gain");
  RequireNotNegative(z_integral_gain_1_s2, "z_integral_gain");
  RequirePositive(max_xy_speed_m_s, "max_xy_speed");
  RequirePositive(max_z_speed_m_s, "max_z_speed");
  RequirePositive(max_tilt_rad, "max_tilt");
  RequirePositive(max_z_acceleration_m_s2, "max_z_acceleration");
  RequirePositive(max_xy_integral_m_s2, "max_xy_integral");
  RequirePositive(max_z_integral_m_s2, "max_z_integral");
  RequirePositive(max_integrated_error_m_s, "max_integrated_error");
  if (max_tilt_rad >= models::kPi / 3.0) throw InputError("max_tilt must be below 60 degrees");
  if (max_z_acceleration_m_s2 >= models::kGravity_m_s2) throw InputError("max_z_acceleration must be below gravity");
}

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
  asked_thrust_n_ = demand.thrust_n;
  return demand;
}

PositionController::Demand PositionController::Trimmed(const models::TaitBryan& attitude) const {
  return DemandFor(Limited(integral_), attitude);
}

Eigen::Vector3d PositionController::Limited(Eigen::Vector3d acceleration) const {
  acceleration.z() = std::clamp(acceleration.z(), -config_.max_z_acceleration_m_s2, config_.max_z_acceleration_m_s2);
  return WithHorizontalLimit(acceleration, std::tan(config_.max_tilt_rad) * (models::kGravity_m_s2 + acceleration.z()));
}

PositionController::Demand PositionController::DemandFor(Eigen::Vector3d acceleration,
                                                         const models::TaitBryan& attitude) const {
  const double forward = std::cos(attitude.yaw) * acceleration.x() + std::sin(attitude.yaw) * acceleration.y();
  const double left = -std::sin(attitude.yaw) * acceleration.x() + std::cos(attitude.yaw) * acceleration.y();
  const double up = models::kGravity_m_s2 + acceleration.z();

  Demand demand;
  demand.pitch = std::atan2(forward, up);
  demand.roll = std::atan2(-left, std::hypot(forward, up));
  constexpr double kLeastUprightness = 0.7;
  const double uprightness = std::max(kLeastUprightness, std::cos(attitude.roll) * std::cos(attitude.pitch));
  demand.thrust_n = mass_kg_ * up / uprightness;
  return demand;
}

void PositionController::Integrate(double achieved_thrust_n) {
  const Eigen::Vector3d error = WithHorizontalLimit(velocity_error_, config_.max_integrated_error_m_s);
  const double z_error = std::clamp(error.z(), -config_.max_integrated_error_m_s, config_.max_integrated_error_m_s);
  constexpr double kTolerance_n = 1e-6;
  const double missing_n = asked_thrust_n_ - achieved_thrust_n;
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
