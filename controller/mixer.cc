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

/// The largest share of `addition`, at most all of it, that keeps `base` between `low` and `high`.
double FittingShare(const Eigen::Vector4d& base, const Eigen::Vector4d& addition, double low, double high) {
  double share = 1.0;
  for (int i = 0; i < addition.size(); ++i) {
    const double room = addition[i] > 0.0 ? high - base[i] : base[i] - low;
    if (addition[i] != 0.0) share = std::min(share, std::max(0.0, room) / std::abs(addition[i]));
  }
  return share;
}

}  // namespace

Mixer::Mixer(const models::Vehicle& vehicle)
    : rotor_(vehicle.rotor),
      wrench_from_thrusts_(WrenchFromThrusts(vehicle)),
      thrusts_from_wrench_(wrench_from_thrusts_.inverse()) {}

Mixer::Result Mixer::Mix(const Wrench& wanted) const {
  const double low = rotor_.ThrustAt(rotor_.min_speed_rad_s);
  const double high = rotor_.ThrustAt(rotor_.max_speed_rad_s);

  RotorThrusts tilting = thrusts_from_wrench_ * Eigen::Vector4d(0.0, wanted.torque_n_m.x(), wanted.torque_n_m.y(), 0.0);
  const double spread = tilting.maxCoeff() - tilting.minCoeff();
  if (spread > high - low) tilting *= (high - low) / spread;

  const double lowest_share = low - tilting.minCoeff();
  const double highest_share = std::max(lowest_share, high - tilting.maxCoeff());
  const double collective = std::clamp(wanted.thrust_n / models::kRotorCount, lowest_share, highest_share);
  RotorThrusts thrusts = tilting.array() + collective;

  const RotorThrusts turning = thrusts_from_wrench_.col(3) * wanted.torque_n_m.z();
  thrusts += FittingShare(thrusts, turning, low, high) * turning;

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
