#pragma once

#include <deque>

#include "scenarios/runner/flight_log.h"
#include "scenarios/runner/scenario.h"
#include "scenarios/runner/vision_timer.h"

namespace touchdown::runner {

/// Records the log of a running flight. It reads the truth but does not pass it to estimator or controller.
class FlightRecorder {
 public:
  explicit FlightRecorder(const Scenario& scenario);

  /// Records the true state of a tick, the true camera pose and whether the pad is covered. Call once per tick, in
  /// order.
  void OnTruth(const sim::TrueState& truth, const Eigen::Isometry3d& X_WC, bool pad_is_covered,
               controller::Phase phase);
  /// Records the estimate of a frame that is delivered at this tick. Returns the record of the frame.
  const FrameRecord& OnFrame(const estimator::FrameResult& estimate, double render_ms, const VisionTime& vision);
  void OnControl(const models::VehicleEstimate& estimate, const controller::ControlOutput& control);

  /// Closes the log.
  FlightLog Finish(Outcome outcome, std::string reason);

 private:
  /// True state for frames that are not delivered yet.
  struct Instant {
    sim::TrueState truth;
    Eigen::Isometry3d X_WC;
    bool pad_is_covered;
  };

  void WatchContact(const sim::TrueState& truth, controller::Phase phase);
  const Instant& At(models::Tick tick) const;

  models::CameraModel camera_;
  models::LandingPad pad_;
  bool has_pad_;
  models::Tick history_ticks_;
  std::deque<Instant> history_;  ///< One entry per tick, the newest last.
  controller::Phase phase_ = controller::Phase::kStandby;
  bool is_clear_of_ground_ = false;
  FlightLog log_;
};

}  // namespace touchdown::runner
