#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>

#include "estimator/estimator_setup.h"
#include "models/time.h"

namespace touchdown::estimator::pad {

/// Limits of the difference between consecutive poses. Larger values accept more wrong poses, in particular the wrong
/// one of the two pose hypotheses; smaller values reject correct poses in fast flight.
struct OutlierGateConfig {
  double max_speed_m_s = 3.0;        ///< Growth of the position gate with the time since the reference pose.
  double gate_m = 0.10;              ///< Position gate for a time difference of 0 at the pad.
  double gate_per_distance = 0.10;   ///< Growth of the position gate with the distance from the pad, as noise grows.
  double max_tilt_rate_rad_s = 4.0;  ///< Growth of the tilt gate with the time since the reference pose.
  double gate_rad = 0.20;            ///< Tilt gate for a time difference of 0.
  int agreeing_outliers = 3;         ///< Number of consecutive rejected poses that must agree to be accepted.
  double start_gate_m = 0.7;         ///< Position gate around the initial pose, before the first accepted pose.
  double start_gate_rad = 0.5;       ///< Tilt gate around the initial pose, before the first accepted pose.

  /// Throws InputError when a value is not finite and positive.
  void Validate() const;
};

/// Rejects poses that jump (Sec. IV-C.2).
///
/// A pose agrees with a reference pose when its position differs by at most gate_m + gate_per_distance * distance from
/// the pad + max_speed_m_s * dt, and its vertical by at most gate_rad + max_tilt_rate_rad_s * dt, where dt is the time
/// between the poses. A pose is accepted when it agrees with the last accepted pose.
///
/// The first pose of a flight must be within start_gate_m and start_gate_rad of the pose on the ground at which the
/// paper starts (Sec. VI-B.1): (0, 0, 0.3 m) and level. The first pose of FrameOrder::kSequence is always accepted, and
/// so is every pose of FrameOrder::kUnrelated.
///
/// A rejected pose becomes a candidate. When `agreeing_outliers` consecutive rejected poses each agree with the
/// previous one, the last of them is accepted. Hence the gate recovers from a wrong reference pose.
class OutlierGate {
 public:
  /// Throws InputError for an invalid config.
  OutlierGate(const OutlierGateConfig& config, const models::TimeBase& time,
              FrameOrder frame_order = FrameOrder::kFlight);

  /// Returns whether the pose at `tick` is accepted, and updates the gate in both cases. Ticks must not decrease.
  bool Accepts(models::Tick tick, const Eigen::Isometry3d& X_WB);

 private:
  struct Reference {
    models::Tick tick;
    Eigen::Isometry3d X_WB;
  };

  bool Agrees(const Reference& reference, models::Tick tick, const Eigen::Isometry3d& X_WB) const;
  bool IsPlausibleStart(const Eigen::Isometry3d& X_WB) const;

  OutlierGateConfig config_;
  models::TimeBase time_;
  FrameOrder frame_order_;
  std::optional<Reference> accepted_;
  std::optional<Reference> candidate_;
  int candidate_count_ = 0;
};

}  // namespace touchdown::estimator::pad
