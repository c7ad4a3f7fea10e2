#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "controller/flight_controller.h"
#include "estimator/frame_result.h"
#include "models/signals.h"
#include "models/time.h"
#include "scenarios/runner/scenario.h"
#include "sim/dynamics/true_state.h"

namespace touchdown::runner {

/// Record of an IMU tick.
struct TickRecord {
  sim::TrueState truth;
  models::VehicleEstimate estimate;
  controller::ControlOutput control;
};

/// Record of a delivered camera frame.
struct FrameRecord {
  models::Tick delivered = 0;
  models::Tick mid_exposure = 0;
  controller::Phase phase = controller::Phase::kStandby;  ///< When it was delivered.
  estimator::FrameStatus status = estimator::FrameStatus::kNotFound;
  std::string reason;                         ///< FrameResult::reason.
  std::optional<estimator::VisionPose> pose;  ///< Unfiltered.
  std::optional<Eigen::Vector2d> pad_px;      ///< As detected.

  // The truth at mid-exposure.
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  std::optional<Eigen::Vector2d> true_pad_px;  ///< nullopt when there is no pad to be seen: absent, covered or behind.
  bool ring_in_view = false;                   ///< The whole ring is in the image, uncovered.
  bool pad_is_covered = false;

  // By the wall clock.
  double render_ms = 0.0;
  double vision_ms = 0.0;
  double geometry_ms = 0.0;  ///< Of it, what fell to FrameStage::kGeometry.
};

/// Record of a pose of the tracking system.
struct TrackingRecord {
  models::TrackedPose tracked;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();  ///< The truth.
};

/// A flight as it was, in full: logs, metrics and pictures are made of it.
struct FlightLog {
  models::TimeBase time;
  std::vector<TickRecord> ticks;
  std::vector<FrameRecord> frames;
  std::vector<TrackingRecord> tracking;
  /// The truth on the tick before a foot first touched the ground in a landing, and on the tick itself.
  struct FirstContact {
    sim::TrueState before;
    sim::TrueState at;
  };
  std::optional<FirstContact> touchdown;
  models::Tick end = 0;

  Outcome outcome = Outcome::kError;
  std::string reason;   ///< In a few words, why it ended so.
  double wall_s = 0.0;  ///< Of the loop, observers not counted.
};

}  // namespace touchdown::runner
