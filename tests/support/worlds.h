#pragma once

#include "models/vehicle.h"
#include "sim/dynamics/world.h"
#include "tests/support/empty_room.h"

namespace touchdown::tests {

inline models::Vehicle VehicleWithoutDrag() {
  models::Vehicle vehicle;
  vehicle.linear_drag_n_s_m.setZero();
  vehicle.quadratic_drag_n_s2_m2.setZero();
  return vehicle;
}

/// Configuration with still air, balanced rotors and no textures.
inline sim::WorldConfig StillAndBalanced() {
  sim::WorldConfig config;
  config.vibration.imbalance_kg_m = 0.0;
  config.paint_textures = false;
  return config;
}

/// Default configuration without textures.
inline sim::WorldConfig Unpainted() {
  sim::WorldConfig config;
  config.paint_textures = false;
  return config;
}

/// World with `vehicle` in an empty room, still air and balanced rotors.
inline sim::World QuietWorld(const models::Vehicle& vehicle) {
  return sim::World(StillAndBalanced(), vehicle, EmptyRoom(), models::TimeBase{}, 1);
}

/// X_WB of a level body with its X axis along X_W.
inline Eigen::Isometry3d LevelPose(double x_m, double y_m, double z_m) {
  return Eigen::Isometry3d(Eigen::Translation3d(x_m, y_m, z_m));
}

inline models::RotorCommand SameSpeed(double speed_rad_s) {
  return {{speed_rad_s, speed_rad_s, speed_rad_s, speed_rad_s}};
}

inline models::RotorCommand HoverCommand(const models::Vehicle& vehicle) {
  return SameSpeed(vehicle.rotor.SpeedFor(vehicle.HoverThrustPerRotor()));
}

inline void StepFor(sim::World& world, const models::RotorCommand& command, double duration_s) {
  const models::Tick ticks = models::TimeBase{}.FromSeconds(duration_s);
  for (models::Tick i = 0; i < ticks; ++i) world.Step(command);
}

}  // namespace touchdown::tests
