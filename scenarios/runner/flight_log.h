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
#include "scenarios/runner/logged_sensors.h"
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
  controller::Phase phase = controller::Phase::kStandby;  ///< Phase at delivery.
  estimator::FrameStatus status = estimator::FrameStatus::kNotFound;
  std::string reason;                         ///< FrameResult::reason.
  std::optional<estimator::VisionPose> pose;  ///< Unfiltered.
  std::optional<Eigen::Vector2d> pad_px;      ///< Detected center of the pad.

  // Truth at mid-exposure.
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  /// nullopt if the pad is absent, covered or behind the camera.
  std::optional<Eigen::Vector2d> true_pad_px;
  bool ring_in_view = false;  ///< The whole ring is in the image and not covered.
  bool pad_is_covered = false;

  // Wall-clock times.
  double render_ms = 0.0;
  double vision_ms = 0.0;
  double geometry_ms = 0.0;  ///< Portion of vision_ms spent in FrameStage::kGeometry.
};

/// Complete record of a flight, the source of its logs, metrics and figures.
struct FlightLog {
  models::TimeBase time;
  std::vector<TickRecord> ticks;
  std::vector<FrameRecord> frames;
  LoggedSensors::Records sensors;
  /// True state at the tick before the first ground contact of a landing, and at the tick of contact.
  struct FirstContact {
    sim::TrueState before;
    sim::TrueState at;
  };
  std::optional<FirstContact> touchdown;
  models::Tick end = 0;

  Outcome outcome = Outcome::kError;
  std::string reason;   ///< Reason for the outcome, in a few words.
  double wall_s = 0.0;  ///< Wall-clock duration of the loop without its observers.

  /// Records of one of the logged sensors.
  template <typename Sensor>
  const std::vector<SensorRecord<Sensor>>& Records() const {
    return std::get<std::vector<SensorRecord<Sensor>>>(sensors);
  }
};

}  // namespace touchdown::runner
