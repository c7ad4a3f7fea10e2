#pragma once

#include <Eigen/Core>

#include "models/vehicle.h"

namespace touchdown::sim {

/// Drag on the body at its origin, N, in B, for its velocity through the air, m/s, in B. On each axis linear (the
/// rotors' induced and blade drag) plus quadratic (the fuselage): -(c_i + q_i |v|) v_i.
Eigen::Vector3d DragForce(const models::Vehicle& vehicle, const Eigen::Vector3d& v_air_B);

}  // namespace touchdown::sim
