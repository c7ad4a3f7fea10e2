#pragma once

#include <Eigen/Core>

#include "models/vehicle.h"

namespace touchdown::sim {

/// Drag force on the body at its origin, N, in B, given its velocity v relative to the air, m/s, in B. On axis i it is
/// -(c_i + q_i |v|) v_i: a linear part (induced and blade drag of the rotors) plus a quadratic part (fuselage).
Eigen::Vector3d DragForce(const models::Vehicle& vehicle, const Eigen::Vector3d& v_air_B);

}  // namespace touchdown::sim
