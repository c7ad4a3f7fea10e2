#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>

#include "models/time.h"
#include "models/vehicle.h"

namespace touchdown::sim {

/// True state at a tick, which only sim/ and scenarios/ use. Values over "the last tick" are 0 at tick 0.
struct TrueState {
  models::Tick tick = 0;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  Eigen::Vector3d v_WB = Eigen::Vector3d::Zero();        ///< m/s, in W.
  Eigen::Vector3d w_WB_B = Eigen::Vector3d::Zero();      ///< rad/s, in B.
  Eigen::Vector3d a_WB = Eigen::Vector3d::Zero();        ///< m/s^2, in W, of B's origin: mean over the last tick.
  Eigen::Vector3d alpha_WB_B = Eigen::Vector3d::Zero();  ///< rad/s^2, in B: mean over the last tick.
  std::array<double, models::kRotorCount> rotor_speed_rad_s{};
  Eigen::Vector3d vibration_m_s2_B =
      Eigen::Vector3d::Zero();   ///< Acceleration of B's origin from the imbalances alone, in B.
  bool gear_in_contact = false;  ///< A landing gear contact point touches the ground or an object.
  bool body_in_contact = false;  ///< Another part of the vehicle touches the ground or an object.
};

}  // namespace touchdown::sim
