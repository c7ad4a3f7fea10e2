#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <optional>

#include "models/random_stream.h"
#include "models/signals.h"
#include "sim/dynamics/true_state.h"

namespace touchdown::sim {

/// The external tracking system (Sec. III-C): a few millimetres, about a degree, and occlusions of its markers that
/// give outliers or gaps (Sec. VI-B.1).
struct TrackingSystemConfig {
  int rate_hz = 100;
  double position_noise_m = 0.002;     ///< 1-sigma, per axis.
  double rotation_noise_rad = 0.0087;  ///< 1-sigma, per axis.
  double occlusions_per_s = 0.05;      ///< Mean rate at which an occlusion begins.
  double occlusion_duration_s = 0.2;   ///< Mean length.
  double outlier_probability = 0.5;    ///< That an occlusion gives outliers; otherwise a gap.
  double outlier_position_m = 0.15;    ///< 1-sigma per axis of an outlier's offset, constant over the occlusion.
  double outlier_rotation_rad = 0.2;

  /// Throws InputError when the rate does not divide `time`'s, a number is negative or not finite, the
  /// probability exceeds 1, or more occlusions than poses are asked for.
  void Validate(const models::TimeBase& time) const;
};

/// White noise on position and rotation. Occlusions begin as a Poisson process (while none lasts) and have
/// exponentially distributed lengths.
class TrackingSystem {
 public:
  /// Noise comes from the stream "tracking.noise", occlusions from "tracking.occlusion".
  TrackingSystem(const TrackingSystemConfig& config, const models::TimeBase& time, std::uint64_t seed);

  /// Call once a tick, in order; returns a pose on the ticks of its rate, unless the markers are occluded.
  std::optional<models::TrackedPose> Sample(const TrueState& truth);

 private:
  struct Occlusion {
    double begin_s = 0.0;
    double end_s = 0.0;
    bool gap = false;
    Eigen::Vector3d position_offset = Eigen::Vector3d::Zero();  ///< In W.
    Eigen::Vector3d rotation_offset = Eigen::Vector3d::Zero();  ///< Rotation vector in B.
  };

  std::optional<Occlusion> OcclusionAfter(double time_s);

  TrackingSystemConfig config_;
  models::TimeBase time_;
  models::Tick period_;
  models::RandomStream noise_;
  models::RandomStream occlusion_random_;
  std::optional<Occlusion> next_;  ///< The present or the coming one; nullopt when there are none.
};

}  // namespace touchdown::sim
