#pragma once

#include <Eigen/Core>

#include "models/angles.h"
#include "models/describe.h"
#include "models/signals.h"
#include "models/vehicle.h"

namespace touchdown::controller {

/// Options of the position controller. On each axis of W, a position P controller commands velocities to a velocity PI
/// controller, which commands accelerations. The integrator uses the velocity error, so that a step of the set-point
/// does not wind it up. The horizontal gains are low because the velocity lags:
/// it comes from vision through a filter that does not use the acceleration.
struct PositionControllerConfig {
  double xy_position_gain_1_s = 1.1;
  double xy_velocity_gain_1_s = 2.4;
  double xy_integral_gain_1_s2 = 1.2;
  double z_position_gain_1_s = 2.0;
  double z_velocity_gain_1_s = 4.5;
  double z_integral_gain_1_s2 = 1.5;

  double max_xy_speed_m_s = 0.7;
  double max_z_speed_m_s = 0.5;
  double max_tilt_deg = 20.0;
  double max_z_acceleration_m_s2 = 3.0;
  double max_xy_integral_m_s2 = 1.5;  // 8.7 deg of trim: 4.8 m/s of wind.
  double max_z_integral_m_s2 = 2.0;
  double max_integrated_error_m_s = 0.6;

  /// Throws InputError for a value out of its range (see Describe).
  void Validate() const;
};

void Describe(models::ConfigVisitor& v, PositionControllerConfig& config);

/// Outer loop of the controller (Sec. V, after Michael et al. and Mellinger et al.). It computes collective thrust,
/// roll and pitch from position and velocity.
class PositionController {
 public:
  struct Target {
    Eigen::Vector3d p_m = Eigen::Vector3d::Zero();    ///< Set-point in W.
    Eigen::Vector3d v_m_s = Eigen::Vector3d::Zero();  ///< Its velocity.
  };
  struct Demand {
    double thrust_n = 0.0;
    double roll = 0.0;
    double pitch = 0.0;
  };

  /// `period_s` is the time between two calls of Update.
  PositionController(const PositionControllerConfig& config, const models::Vehicle& vehicle, double period_s);

  /// Thrust and tilt towards `target`, at the current yaw. The thrust compensates the current tilt.
  Demand Update(const Target& target, const models::VehicleEstimate::Motion& motion, const models::TaitBryan& attitude);

  /// Thrust and tilt that balance the trim.
  Demand Trimmed(const models::TaitBryan& attitude) const;

  /// Integrates the velocity error of the newest Update, except where the tilt, the acceleration or (according to
  /// `achieved_thrust_n`) the rotors are at a limit and the error would increase the demand (anti-windup).
  void Integrate(double achieved_thrust_n);

  /// Sets the trim to the tilt of the standing vehicle, which is correct on a level pad (the second assumption of Sec.
  /// IV-C.2) for any level error of the IMU.
  void SetTrimFromStance(const models::TaitBryan& attitude);

  /// Acceleration in W, m/s^2, with which the integrators balance constant disturbances.
  const Eigen::Vector3d& trim_m_s2() const { return integral_; }

 private:
  Demand DemandFor(Eigen::Vector3d acceleration, const models::TaitBryan& attitude) const;
  Eigen::Vector3d Limited(Eigen::Vector3d acceleration) const;

  PositionControllerConfig config_;
  double mass_kg_;
  double period_s_;
  Eigen::Vector3d position_gain_, velocity_gain_, integral_gain_;
  Eigen::Vector3d velocity_error_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d excess_ = Eigen::Vector3d::Zero();  ///< Demanded minus limited acceleration.
  double requested_thrust_n_ = 0.0;
  Eigen::Vector3d integral_ = Eigen::Vector3d::Zero();
};

}  // namespace touchdown::controller
