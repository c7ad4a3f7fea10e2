#include "controller/mixer.h"

#include <algorithm>

namespace touchdown::controller {
namespace {

Eigen::Matrix4d WrenchFromThrusts(const models::Vehicle& vehicle) {
  Eigen::Matrix4d matrix;
  for (int rotor = 0; rotor < models::kRotorCount; ++rotor) {
    const Eigen::Vector3d p_BR = vehicle.RotorPosition(rotor);
    matrix.col(rotor) << 1.0, p_BR.y(), -p_BR.x(),
        models::Vehicle::DragTorqueSign(rotor) * vehicle.rotor.torque_ratio_m;
  }
  return matrix;
}

/// Largest factor, at most 1, by which `addition` can be scaled so that base + factor * addition stays between `low`
/// and `high`.
double FeasibleScale(const Eigen::Vector4d& base, const Eigen::Vector4d& addition, double low, double high) {
  double scale = 1.0;
  for (int i = 0; i < addition.size(); ++i) {
    const double margin = addition[i] > 0.0 ? high - base[i] : base[i] - low;
    if (addition[i] != 0.0) scale = std::min(scale, std::max(0.0, margin) / std::abs(addition[i]));
  }
  return scale;
}

}  // namespace

Mixer::Mixer(const models::Vehicle& vehicle)
    : rotor_(vehicle.rotor),
      wrench_from_thrusts_(WrenchFromThrusts(vehicle)),
      thrusts_from_wrench_(wrench_from_thrusts_.inverse()) {}

Mixer::Result Mixer::Mix(const Wrench& demand) const {
  const double low = rotor_.ThrustAt(rotor_.min_speed_rad_s);
  const double high = rotor_.ThrustAt(rotor_.max_speed_rad_s);

  RotorThrusts tilting = thrusts_from_wrench_ * Eigen::Vector4d(0.0, demand.torque_n_m.x(), demand.torque_n_m.y(), 0.0);
  const double spread = tilting.maxCoeff() - tilting.minCoeff();
  if (spread > high - low) tilting *= (high - low) / spread;

  const double min_collective = low - tilting.minCoeff();
  const double max_collective = std::max(min_collective, high - tilting.maxCoeff());
  const double collective = std::clamp(demand.thrust_n / models::kRotorCount, min_collective, max_collective);
  RotorThrusts thrusts = tilting.array() + collective;

  const RotorThrusts turning = thrusts_from_wrench_.col(3) * demand.torque_n_m.z();
  thrusts += FeasibleScale(thrusts, turning, low, high) * turning;

  Result result;
  for (int rotor = 0; rotor < models::kRotorCount; ++rotor) {
    const double thrust = std::clamp(thrusts[rotor], low, high);
    result.rotors.speed_rad_s[static_cast<std::size_t>(rotor)] = rotor_.SpeedFor(thrust);
  }
  result.achieved = WrenchOf(result.rotors);
  return result;
}

Wrench Mixer::WrenchOf(const models::RotorCommand& command) const {
  RotorThrusts thrusts;
  for (int rotor = 0; rotor < models::kRotorCount; ++rotor) {
    thrusts[rotor] = rotor_.ThrustAt(command.speed_rad_s[static_cast<std::size_t>(rotor)]);
  }
  const Eigen::Vector4d wrench = wrench_from_thrusts_ * thrusts;
  return {wrench[0], wrench.tail<3>()};
}

}  // namespace touchdown::controller
