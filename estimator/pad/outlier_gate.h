#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>

#include "estimator/estimator_setup.h"
#include "models/time.h"

namespace touchdown::estimator::pad {

/// How far a pose may be from the one before. Larger values let wrong poses through (the wrong one of the two solutions
/// above all), smaller ones reject right ones in fast flight.
struct OutlierGateConfig {
  double fastest_m_s = 3.0;         ///< The vehicle's speed; the room grows with the time since the reference.
  double room_m = 0.10;             ///< Room at no time, near the pad ...
  double room_per_distance = 0.10;  ///< ... and what is added per meter of distance from it: noise grows with it.
  double fastest_rad_s = 4.0;       ///< The rate at which the tilt changes.
  double room_rad = 0.20;
  int agreeing_outliers = 3;  ///< So many rejected poses in a row that agree with each other are the truth.
  double start_room_m = 0.7;  ///< Room about the initial pose, before the first accepted one.
  double start_room_rad = 0.5;

  /// Throws InputError when a number is not finite and positive.
  void Validate() const;
};

/// Rejects jumps of the pose (Sec. IV-C.2).
///
/// A pose agrees with a reference pose when its position is within room_m + room_per_distance * distance from the pad +
/// fastest_m_s * dt, and its vertical is within room_rad + fastest_rad_s * dt, dt being the time between them. It is
/// accepted when it agrees with the last accepted pose. Until there is one, the reference is the pose on the ground
/// from which the paper starts (Sec. VI-B.1), (0, 0, 0.3 m) and level, with start_room_m to all sides and
/// start_room_rad; in a film that begins anywhere the first pose is accepted. A rejected pose is kept as a candidate:
/// when as many in a row as agreeing_outliers each agree with the one before, the last of them is accepted after all,
/// so that the gate cannot lock itself out. Of pictures that are unrelated every pose is accepted.
class OutlierGate {
 public:
  OutlierGate(const OutlierGateConfig& config, const models::TimeBase& time,
              FrameOrder frame_order = FrameOrder::kFlight);

  /// Whether the pose at `tick` is accepted; remembers it either way. Ticks must not fall.
  bool Accepts(models::Tick tick, const Eigen::Isometry3d& X_WB);

 private:
  struct Reference {
    models::Tick tick;
    Eigen::Isometry3d X_WB;
  };

  bool Agrees(const Reference& reference, models::Tick tick, const Eigen::Isometry3d& X_WB) const;
  bool MayBeFirst(const Eigen::Isometry3d& X_WB) const;

  OutlierGateConfig config_;
  models::TimeBase time_;
  FrameOrder frame_order_;
  std::optional<Reference> accepted_;
  std::optional<Reference> candidate_;
  int candidate_count_ = 0;
};

}  // namespace touchdown::estimator::pad
