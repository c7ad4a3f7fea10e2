#include "tests/support/quadrotor_ode.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace touchdown::tests {

using Eigen::Vector3d;

Eigen::Vector4d QuadrotorOde::RotorWrench(const models::Vehicle& vehicle,
                                          const std::array<double, models::kRotorCount>& speeds) {
  Eigen::Vector4d wrench = Eigen::Vector4d::Zero();
  for (int i = 0; i < models::kRotorCount; ++i) {
    const double speed = speeds[static_cast<std::size_t>(i)];
    const Vector3d force(0.0, 0.0, vehicle.rotor.thrust_coefficient_n_s2 * speed * speed);
    const bool clockwise = i == 0 || i == 2;
    const Vector3d drag(0.0, 0.0, (clockwise ? 1.0 : -1.0) * vehicle.rotor.torque_ratio_m * force.z());
    wrench[0] += force.z();
    wrench.tail<3>() += vehicle.RotorPosition(i).cross(force) + drag;
  }
  return wrench;
}

void QuadrotorOde::StartRotorsAtHover() {
  state.rotor_speed.fill(std::sqrt(vehicle_.mass_kg * 9.81 / 4.0 / vehicle_.rotor.thrust_coefficient_n_s2));
}

QuadrotorOde::Load QuadrotorOde::Ground() {
  constexpr double kStiffness = 4000.0, kDamping = 60.0, kFriction = 0.7, kCreep = 0.02;
  Load load;
  contact_ = false;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const Vector3d point_B(x * vehicle_.gear.half_spacing_m, y * vehicle_.gear.half_spacing_m,
                             -vehicle_.gear.height_m);
      const Vector3d point = state.p + state.R * point_B;
      if (point.z() >= 0.0) continue;
      contact_ = true;
      const Vector3d velocity = state.v + state.R * state.w.cross(point_B);
      const double normal = std::max(0.0, -kStiffness * point.z() - kDamping * velocity.z());
      const Eigen::Vector2d slide = velocity.head<2>();
      Vector3d force(0.0, 0.0, normal);
      force.head<2>() = -kFriction * normal * slide / std::max(kCreep, slide.norm());
      load.force_W += force;
      load.torque_B += point_B.cross(Vector3d(state.R.transpose() * force));
    }
  }
  return load;
}

void QuadrotorOde::Step(const models::RotorCommand& command, double dt) {
  for (std::size_t i = 0; i < state.rotor_speed.size(); ++i) {
    const double target = std::clamp(command.speed_rad_s[i], 0.0, vehicle_.rotor.max_speed_rad_s);
    state.rotor_speed[i] += (target - state.rotor_speed[i]) * -std::expm1(-dt / vehicle_.rotor.time_constant_s);
  }
  const Eigen::Vector4d rotors = RotorWrench(vehicle_, state.rotor_speed);
  const Vector3d air_B = state.R.transpose() * (state.v - wind);
  const Vector3d drag_B = -vehicle_.linear_drag_n_s_m.cwiseProduct(air_B) -
                          vehicle_.quadratic_drag_n_s2_m2.cwiseProduct(air_B.cwiseAbs().cwiseProduct(air_B));
  const Load ground = Ground();
  const Vector3d force = state.R * (Vector3d(0.0, 0.0, rotors[0]) + drag_B) + ground.force_W + push_n;
  const Vector3d specific_W = force / vehicle_.mass_kg;
  const Vector3d& J = vehicle_.inertia_kg_m2;
  const Vector3d torque = rotors.tail<3>() + ground.torque_B - state.w.cross(Vector3d(J.cwiseProduct(state.w)));

  specific_force_ = state.R.transpose() * specific_W;
  state.v += dt * (specific_W - Vector3d(0.0, 0.0, 9.81));
  state.p += dt * state.v;
  state.w += dt * torque.cwiseQuotient(J);
  const double turn = state.w.norm() * dt;
  if (turn > 0.0) state.R = state.R * Eigen::AngleAxisd(turn, state.w.normalized()).toRotationMatrix();
  state.R = Eigen::Quaterniond(state.R).normalized().toRotationMatrix();
}

}  // namespace touchdown::tests
