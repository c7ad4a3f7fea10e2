#pragma once

#include <cstdint>
#include <optional>

#include "models/signals.h"
#include "sim/true_state.h"

namespace touchdown::sim {

/// The external tracking system (Sec. III-C): a few millimetres, about a degree, and occlusions of its markers that give
/// outliers or gaps (Sec. VI-B.1).
struct TrackingSystemConfig {
  int rate_hz = 100;
  double position_noise_m = 0.002;
  double rotation_noise_rad = 0.0087;
  double occlusions_per_s = 0.05;      ///< Mean rate at which an occlusion begins.
  double occlusion_duration_s = 0.2;   ///< Mean length.
  double outlier_probability = 0.5;    ///< That an occlusion gives outliers; otherwise a gap.
  double outlier_position_m = 0.15;    ///< 1-sigma of an outlier's offset, constant over the occlusion.
  double outlier_rotation_rad = 0.2;

  void Validate(const models::TimeBase& time) const;
};

class TrackingSystem {
 public:
  TrackingSystem(const TrackingSystemConfig& config, const models::TimeBase& time, std::uint64_t seed);

  /// Call once a tick; returns a pose on the ticks of its rate, unless the markers are occluded.
  std::optional<models::TrackedPose> Sample(const TrueState& truth);
};

}  // namespace touchdown::sim
