#pragma once

#include <Eigen/Core>
#include <optional>

#include "estimator/estimator.h"
#include "models/signals.h"

namespace touchdown::estimator {

struct PoseFilterConfig {
  double acceleration_noise_m_s2 = 1.0;  ///< 1-sigma of the unknown acceleration: larger follows sooner, with more noise.
  double xy_noise_m = 0.030;             ///< 1-sigma of a vision position, horizontally and vertically.
  double z_noise_m = 0.010;
};

/// The "basic Kalman filter without taking the IMU information into account" of Sec. V: constant velocity on each axis
/// of the vision position.
class PoseFilter {
 public:
  PoseFilter(const PoseFilterConfig& config, const models::TimeBase& time);

  /// Takes the position of a frame with status ok, at its mid-exposure. The first one sets the state.
  void Update(models::Tick mid_exposure, const Eigen::Vector3d& p_WB);

  /// Position and velocity predicted to `tick`; nullopt before the first update.
  std::optional<models::VehicleEstimate::Motion> At(models::Tick tick) const;

  /// Mid-exposure of the newest update; nullopt before the first.
  std::optional<models::Tick> newest() const;

  void Reset();
};

}  // namespace touchdown::estimator
