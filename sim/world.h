#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>

#include "models/landing_pad.h"
#include "models/signals.h"
#include "models/time.h"
#include "models/vehicle.h"
#include "sim/scene.h"
#include "sim/true_state.h"

struct mjModel_;
struct mjData_;

namespace touchdown::sim {

/// The simulation itself went wrong: a MuJoCo warning, a number that is not finite, time running backwards. The flight
/// ends as an error, with status 3.
class SimulationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Rotor imbalance (Sec. VI-B.2: "motion blur from the vibration of the quadrotor").
struct VibrationConfig {
  double imbalance_kg_m = 1.0e-6;  ///< Of each rotor: mass times eccentricity.
};

struct WorldConfig {
  VibrationConfig vibration;
  Eigen::Vector3d wind_m_s = Eigen::Vector3d::Zero();  ///< Mean wind in W.
};

/// MuJoCo flies the vehicle over the scene: rotors, drag, wind, gravity, contact. One Step is one tick.
class World {
 public:
  World(const WorldConfig& config, const models::Vehicle& vehicle, const Scene& scene, const models::TimeBase& time,
        std::uint64_t seed);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Puts the vehicle there, at rest. `rotors_at_hover` starts the rotors at hover speed instead of stopped.
  void Reset(const Eigen::Isometry3d& X_WB, bool rotors_at_hover);

  /// The pose at rest on its feet, the body's origin above (x, y).
  Eigen::Isometry3d RestingPose(double x_m, double y_m, double yaw) const;

  const TrueState& state() const;

  /// One tick under the command. Throws SimulationError.
  void Step(const models::RotorCommand& command);

  void SetWind(const Eigen::Vector3d& wind_m_s);
  /// External force in W at the body's origin, N, and torque in W, Nm, until set again.
  void SetPush(const Eigen::Vector3d& force_n, const Eigen::Vector3d& torque_n_m);
  /// Lays a plain sheet over the pad, or takes it away.
  void CoverPad(bool covered);

  /// For the renderer.
  const mjModel_& model() const;
  mjData_& data();
};

}  // namespace touchdown::sim
