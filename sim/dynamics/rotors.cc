#include "sim/dynamics/rotors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "models/angles.h"
#include "models/random_stream.h"

namespace touchdown::sim {
namespace {

/// Exact response of a first-order lag to a constant command.
struct Lag {
  double start, command, time_constant_s;

  double At(double time_s) const { return command + (start - command) * std::exp(-time_s / time_constant_s); }
  double IntegralTo(double time_s) const {
    return command * time_s - (start - command) * time_constant_s * std::expm1(-time_s / time_constant_s);
  }
};

void AddForceAt(const Eigen::Vector3d& p_B, const Eigen::Vector3d& force, Wrench& wrench) {
  wrench.force_n += force;
  wrench.torque_n_m += p_B.cross(force);
}

}  // namespace

void Describe(models::ConfigVisitor& v, VibrationConfig& c) {
  v.Number(
      {"imbalance_kg_m",
       "Imbalance of each rotor, mass times eccentricity, +-20 % from rotor to rotor. A larger value shakes IMU and "
       "camera more."},
      c.imbalance_kg_m, {"kg m"}, models::Between(0.0, 1.0));
}

void VibrationConfig::Validate() const { models::ValidateConfig(*this); }

Rotors::Rotors(const models::Vehicle& vehicle, const VibrationConfig& vibration, const models::TimeBase& time,
               std::uint64_t seed)
    : vehicle_(vehicle), period_s_(time.period_s()) {
  vibration.Validate();
  models::RandomStream random(seed, "vibration");
  for (int i = 0; i < models::kRotorCount; ++i) {
    first_angles_rad_[i] = random.Uniform(-models::kPi, models::kPi);
    imbalances_kg_m_[i] = vibration.imbalance_kg_m * random.Uniform(0.8, 1.2);
  }
  Reset(0.0);
}

void Rotors::Reset(double speed_rad_s) {
  speeds_rad_s_.fill(std::clamp(speed_rad_s, 0.0, vehicle_.rotor.max_speed_rad_s));
  angles_rad_ = first_angles_rad_;
}

Wrench Rotors::Step(const models::RotorCommand& command) {
  const models::Rotor& rotor = vehicle_.rotor;
  Wrench wrench;
  for (int i = 0; i < models::kRotorCount; ++i) {
    const Lag lag{speeds_rad_s_[i], std::clamp(command.speed_rad_s[i], 0.0, rotor.max_speed_rad_s),
                  rotor.time_constant_s};
    const double spin = -models::Vehicle::DragTorqueSign(i);
    const double middle_s = 0.5 * period_s_;
    const double speed = lag.At(middle_s);
    const double thrust = rotor.ThrustAt(speed);

    AddForceAt(
        vehicle_.RotorPosition(i),
        Eigen::Vector3d(0.0, 0.0, thrust) + ImbalanceForce(i, speed, angles_rad_[i] + spin * lag.IntegralTo(middle_s)),
        wrench);
    wrench.torque_n_m.z() += models::Vehicle::DragTorqueSign(i) * rotor.torque_ratio_m * thrust;

    angles_rad_[i] = models::WrapToPi(angles_rad_[i] + spin * lag.IntegralTo(period_s_));
    speeds_rad_s_[i] = lag.At(period_s_);
  }
  return wrench;
}

Wrench Rotors::Imbalance() const {
  Wrench wrench;
  for (int i = 0; i < models::kRotorCount; ++i) {
    AddForceAt(vehicle_.RotorPosition(i), ImbalanceForce(i, speeds_rad_s_[i], angles_rad_[i]), wrench);
  }
  return wrench;
}

Eigen::Vector3d Rotors::ImbalanceForce(int rotor, double speed_rad_s, double angle_rad) const {
  const double force = imbalances_kg_m_[rotor] * speed_rad_s * speed_rad_s;
  return force * Eigen::Vector3d(std::cos(angle_rad), std::sin(angle_rad), 0.0);
}

}  // namespace touchdown::sim
