#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "models/describe.h"
#include "models/signals.h"
#include "models/time.h"
#include "models/vehicle.h"

namespace touchdown::sim {

/// Rotor imbalance (Sec. VI-B.2: "motion blur from the vibration of the quadrotor").
struct VibrationConfig {
  double imbalance_kg_m = 1.0e-6;

  /// Throws InputError for a value out of its range (see Describe).
  void Validate() const;
};

void Describe(models::ConfigVisitor& v, VibrationConfig& config);

/// Force and torque on the body at its origin, in B.
struct Wrench {
  Eigen::Vector3d force_n = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque_n_m = Eigen::Vector3d::Zero();
};

/// Four rotors whose speeds follow their commands as a first-order lag. Each gives thrust along +Z_B at its hub, drag
/// torque about Z_B (see models::Vehicle), and the force of its imbalance, which rotates with it in the rotor plane.
/// The reaction to the rotors' own acceleration and their gyroscopic moment are not modeled.
class Rotors {
 public:
  /// Draws the phase and the imbalance of each rotor from the stream "vibration". The rotors are stopped until Reset.
  Rotors(const models::Vehicle& vehicle, const VibrationConfig& vibration, const models::TimeBase& time,
         std::uint64_t seed);

  /// Sets all rotors to this speed, rad/s, and to their initial phases.
  void Reset(double speed_rad_s);

  /// Advances by one tick, with the commanded speeds clamped to [0, max_speed_rad_s]. Returns the wrench at the middle
  /// of the tick.
  Wrench Step(const models::RotorCommand& command);

  const std::array<double, models::kRotorCount>& speeds_rad_s() const { return speeds_rad_s_; }
  /// Direction of each imbalance from X_B towards Y_B, rad, in (-pi, pi].
  const std::array<double, models::kRotorCount>& angles_rad() const { return angles_rad_; }
  /// Wrench of the imbalances alone, at the current phases.
  Wrench Imbalance() const;

 private:
  Eigen::Vector3d ImbalanceForce(int rotor, double speed_rad_s, double angle_rad) const;

  models::Vehicle vehicle_;
  double period_s_;
  std::array<double, models::kRotorCount> imbalances_kg_m_{};
  std::array<double, models::kRotorCount> first_angles_rad_{};
  std::array<double, models::kRotorCount> speeds_rad_s_{};
  std::array<double, models::kRotorCount> angles_rad_{};
};

}  // namespace touchdown::sim
