#pragma once

#include <Eigen/Core>

namespace touchdown::sim {

/// Tilt of the ground and the pad. W remains the frame of the pad, so that gravity is tilted in W.
///
/// Frame L is W without the tilt: R_LW = Ry(pitch) Rx(roll). A positive roll lowers the ground towards -Y, a positive
/// pitch towards +X.
struct GroundTilt {
  double roll_deg = 0.0;
  double pitch_deg = 0.0;

  /// Throws InputError when an angle is not finite or the ground is steeper than 15 degrees.
  void Validate() const;

  /// Gravity in W, m/s^2.
  Eigen::Vector3d Gravity() const;
};

}  // namespace touchdown::sim
