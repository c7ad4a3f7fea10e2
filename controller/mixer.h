#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>

#include "models/signals.h"
#include "models/vehicle.h"

namespace touchdown::controller {

/// What the rotors together do to the body: a force along +Z_B and a torque in B.
struct Wrench {
  double thrust_n = 0.0;
  Eigen::Vector3d torque_n_m = Eigen::Vector3d::Zero();
};

/// Turns a wanted wrench into rotor speeds, within what running motors can do. What does not fit is given up in this
/// order: yaw torque first, then collective thrust, roll and pitch torque last.
class Mixer {
 public:
  /// Rotors at their steady speeds, and the wrench that those speeds give: after saturation, for anti-windup.
  struct Result {
    models::RotorCommand rotors;
    Wrench achieved;
  };

  explicit Mixer(const models::Vehicle& vehicle);

  Result Mix(const Wrench& wanted) const;

  /// The steady wrench of rotors at `command`'s speeds.
  Wrench WrenchOf(const models::RotorCommand& command) const;

 private:
  using RotorThrusts = Eigen::Vector4d;

  models::Rotor rotor_;
  Eigen::Matrix4d wrench_from_thrusts_;  ///< Rows: thrust, torque about X, Y and Z. Columns: rotors.
  Eigen::Matrix4d thrusts_from_wrench_;
};

}  // namespace touchdown::controller
