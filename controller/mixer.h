#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>

#include "models/signals.h"
#include "models/vehicle.h"

namespace touchdown::controller {

/// Wrench of the rotors on the body: a force along +Z_B and a torque in B.
struct Wrench {
  double thrust_n = 0.0;
  Eigen::Vector3d torque_n_m = Eigen::Vector3d::Zero();
};

/// Converts a demanded wrench to rotor speeds within the limits of running motors. On saturation it reduces the yaw
/// torque first, then the collective thrust, and the roll and pitch torque last.
class Mixer {
 public:
  /// Steady rotor speeds and their wrench after saturation (for the anti-windup).
  struct Result {
    models::RotorCommand rotors;
    Wrench achieved;
  };

  explicit Mixer(const models::Vehicle& vehicle);

  Result Mix(const Wrench& demand) const;

  /// Steady wrench of the rotors at the speeds of `command`.
  Wrench WrenchOf(const models::RotorCommand& command) const;

 private:
  using RotorThrusts = Eigen::Vector4d;

  models::Rotor rotor_;
  Eigen::Matrix4d wrench_from_thrusts_;  ///< Rows: thrust, torque about X, Y and Z. Columns: rotors.
  Eigen::Matrix4d thrusts_from_wrench_;
};

}  // namespace touchdown::controller
