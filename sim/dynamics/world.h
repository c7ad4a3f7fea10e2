#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "models/describe.h"
#include "models/signals.h"
#include "models/time.h"
#include "models/vehicle.h"
#include "sim/dynamics/ground_tilt.h"
#include "sim/dynamics/hand.h"
#include "sim/dynamics/mujoco_errors.h"
#include "sim/dynamics/mujoco_model.h"
#include "sim/dynamics/rotors.h"
#include "sim/dynamics/true_state.h"
#include "sim/scene/scene.h"

namespace touchdown::sim {

struct WorldConfig {
  VibrationConfig vibration;
  Eigen::Vector3d wind_m_s = Eigen::Vector3d::Zero();
  GroundTilt ground_tilt = {};
  bool paint_textures = true;  ///< Only a renderer needs textures; painting them takes most of the set-up time.

  /// Throws InputError for a value out of its range (see Describe), or when the ground is too steep.
  void Validate() const;
};

void Describe(models::ConfigVisitor& v, WorldConfig& config);

/// Simulates the vehicle over the scene with MuJoCo: rotors, drag, wind, gravity, contact. One Step is one tick.
///
/// After a SimulationError, call Reset.
class World {
 public:
  /// Starts at rest on the pad, rotors stopped. Throws InputError for a config, vehicle or scene that is not valid.
  World(const WorldConfig& config, const models::Vehicle& vehicle, const Scene& scene, const models::TimeBase& time,
        std::uint64_t seed);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Sets the vehicle to a pose, at rest, at tick 0; `rotors_at_hover` starts the rotors at hover speed instead of
  /// stopped. Also resets wind, gust, push and pad cover.
  void Reset(const Eigen::Isometry3d& X_WB, bool rotors_at_hover);

  /// Pose at rest on the floor: upright on the landing gear, with the body's origin above (x, y), at the height at
  /// which the contact forces carry the weight.
  Eigen::Isometry3d RestingPose(double x_m, double y_m, double yaw) const;

  const TrueState& state() const { return state_; }

  /// Advances by one tick under the command. Throws SimulationError when the command, a force or the new state is not
  /// finite, or MuJoCo warns.
  void Step(const models::RotorCommand& command);

  /// Advances by one tick in which a hand moves the vehicle to the given state, motors off. Throws SimulationError when
  /// the pose is not finite.
  void Carry(const BodyMotion& motion);

  /// Sets the mean wind in W, m/s, until the next call or Reset.
  void SetWind(const Eigen::Vector3d& wind_m_s) { wind_m_s_ = wind_m_s; }
  /// Sets the velocity in W, m/s, that is added to the mean wind until the next call or Reset.
  void SetGust(const Eigen::Vector3d& gust_m_s) { gust_m_s_ = gust_m_s; }
  /// Sets the external force at the body's origin, N, and torque, Nm, both in W, until the next call or Reset.
  void SetPush(const Eigen::Vector3d& force_n, const Eigen::Vector3d& torque_n_m);
  /// Shows or hides a plain sheet over the pad. It has no effect on the physics.
  void CoverPad(bool covered);

  /// Distance from `p_W` along the unit vector `direction_W` to the nearest visible surface, m, without the vehicle;
  /// nullopt if there is none.
  std::optional<double> DistanceAlong(const Eigen::Vector3d& p_W, const Eigen::Vector3d& direction_W) const;

  /// For the renderer.
  const mjModel_& model() const { return *model_; }
  mjData_& data() { return *data_; }

 private:
  double FindRestingHeight();
  double FindContactCeiling() const;
  Wrench AppliedWrench(const models::RotorCommand& command);
  void ApplyForces(const Wrench& wrench);
  void StepMujoco();
  void Advance();
  void ReadState();
  void ReadContacts();

  WorldConfig config_;
  models::Vehicle vehicle_;
  models::TimeBase time_;
  Rotors rotors_;
  MujocoModel model_;
  MujocoData data_;
  int vehicle_body_ = 0;
  int pad_cover_ = -1;
  std::vector<bool> is_foot_;  ///< Per geom.
  double resting_height_m_ = 0.0;
  double contact_ceiling_m_ = 0.0;  ///< Height of the body's origin above which contact is impossible.
  Eigen::Vector3d wind_m_s_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d gust_m_s_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d push_force_n_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d push_torque_n_m_ = Eigen::Vector3d::Zero();
  TrueState state_;
};

}  // namespace touchdown::sim
