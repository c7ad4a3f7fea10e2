#pragma once

#include <Eigen/Core>
#include <array>

#include "models/signals.h"
#include "models/vehicle.h"

namespace touchdown::tests {

/// Quadrotor as a rigid body with four lagging rotors, drag and elastic landing gear, for tests of estimator and
/// controller. It shares no code with them or with sim/.
class QuadrotorOde {
 public:
  struct State {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    Eigen::Vector3d v = Eigen::Vector3d::Zero();
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    Eigen::Vector3d w = Eigen::Vector3d::Zero();  ///< In the body frame, rad/s.
    std::array<double, models::kRotorCount> rotor_speed{};
  };

  explicit QuadrotorOde(const models::Vehicle& vehicle) : vehicle_(vehicle) {}

  State state;
  Eigen::Vector3d wind = Eigen::Vector3d::Zero();
  Eigen::Vector3d push_n = Eigen::Vector3d::Zero();

  void StartRotorsAtHover();
  void Step(const models::RotorCommand& command, double dt);

  /// Specific force (a - g) of the newest step, in the body frame, m/s^2.
  const Eigen::Vector3d& specific_force() const { return specific_force_; }
  /// Whether the landing gear touches the ground.
  bool contact() const { return contact_; }

  /// Force along body Z and torque in the body frame of rotors at these speeds, summed over the rotors.
  static Eigen::Vector4d RotorWrench(const models::Vehicle& vehicle,
                                     const std::array<double, models::kRotorCount>& speeds);

 private:
  struct Load {
    Eigen::Vector3d force_W = Eigen::Vector3d::Zero();
    Eigen::Vector3d torque_B = Eigen::Vector3d::Zero();
  };
  Load Ground();

  models::Vehicle vehicle_;
  Eigen::Vector3d specific_force_{0.0, 0.0, models::kGravity_m_s2};
  bool contact_ = false;
};

}  // namespace touchdown::tests
