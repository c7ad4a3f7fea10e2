#include "sim/dynamics/aerodynamics.h"

namespace touchdown::sim {

Eigen::Vector3d DragForce(const models::Vehicle& vehicle, const Eigen::Vector3d& v_air_B) {
  const Eigen::Vector3d coefficient = vehicle.linear_drag_n_s_m + vehicle.quadratic_drag_n_s2_m2 * v_air_B.norm();
  return -coefficient.cwiseProduct(v_air_B);
}

}  // namespace touchdown::sim
