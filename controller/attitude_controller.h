#pragma once

#include <Eigen/Core>

#include "models/angles.h"
#include "models/describe.h"
#include "models/vehicle.h"

namespace touchdown::controller {

/// Options of the attitude controller. The gains yield angular accelerations, so they do not depend on the inertia.
/// The defaults are tuned for a rotor lag of 40 ms; faster rotors allow higher gains.
struct AttitudeControllerConfig {
  double roll_pitch_angle_gain_1_s = 8.0;
  double roll_pitch_rate_gain_1_s = 22.0;
  double roll_pitch_rate_integral_gain_1_s2 = 20.0;
  double roll_pitch_rate_derivative_gain = 0.4;
  double derivative_cutoff_hz = 30.0;
  double max_roll_pitch_rate_deg_s = 230.0;
  double max_roll_pitch_integral_rad_s2 = 10.0;

  double yaw_angle_gain_1_s = 2.0;
  double yaw_rate_gain_1_s = 5.0;
  double yaw_rate_integral_gain_1_s2 = 3.0;
  double max_yaw_rate_deg_s = 57.0;
  double max_yaw_integral_rad_s2 = 2.0;

  /// Throws InputError for a value out of its range (see Describe).
  void Validate() const;
};

void Describe(models::ConfigVisitor& v, AttitudeControllerConfig& config);

/// Inner loop of the controller (Sec. V). An angle P controller commands rates to a PID controller of the roll and
/// pitch rates and a PI controller of the yaw rate.
class AttitudeController {
 public:
  /// `period_s` is the time between two calls of Torque.
  AttitudeController(const AttitudeControllerConfig& config, const models::Vehicle& vehicle, double period_s);

  /// Torque in B, Nm, that rotates `attitude` towards `set_point`, including the compensation of the gyroscopic torque.
  Eigen::Vector3d Torque(const models::TaitBryan& set_point, const models::TaitBryan& attitude,
                         const Eigen::Vector3d& w_WB_B);

  /// Integrates the rate error of the newest call, except on axes where the rotors saturated and the error would
  /// increase the demand (anti-windup).
  void Integrate(const Eigen::Vector3d& achieved_torque_n_m);

  /// Resets the integrators and the derivative.
  void Reset();

 private:
  Eigen::Vector3d RateSetPoint(const models::TaitBryan& set_point, const models::TaitBryan& attitude) const;
  Eigen::Vector3d FilteredAcceleration(const Eigen::Vector3d& w_WB_B);

  AttitudeControllerConfig config_;
  Eigen::Vector3d inertia_kg_m2_;
  double period_s_;
  Eigen::Vector3d rate_gain_, integral_gain_, max_integral_;
  Eigen::Vector3d rate_error_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d integral_ = Eigen::Vector3d::Zero();  ///< rad/s^2.
  Eigen::Vector3d requested_torque_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d filtered_rate_ = Eigen::Vector3d::Zero();
  bool has_rate_ = false;
};

}  // namespace touchdown::controller
