#include "scenarios/runner/flight_recorder.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "scenarios/runner/pad_view.h"

namespace touchdown::runner {

FlightRecorder::FlightRecorder(const Scenario& scenario)
    : camera_(scenario.camera.model),
      pad_(scenario.pad),
      has_pad_(scenario.scene.pad),
      history_ticks_(scenario.time.FromSeconds(scenario.camera.latency_s() + scenario.camera.exposure_s()) + 2) {
  log_.time = scenario.time;
}

void FlightRecorder::OnTruth(const sim::TrueState& truth, const Eigen::Isometry3d& X_WC, bool pad_is_covered,
                             controller::Phase phase) {
  WatchContact(truth, phase);
  history_.push_back({truth, X_WC, pad_is_covered});
  if (std::ssize(history_) > history_ticks_) history_.pop_front();
  phase_ = phase;
}

void FlightRecorder::WatchContact(const sim::TrueState& truth, controller::Phase phase) {
  using controller::Phase;
  const bool landing = phase == Phase::kLanding || phase == Phase::kBlindDescent || phase == Phase::kTouchdown;
  if (landing && is_clear_of_ground_ && truth.gear_in_contact && !log_.touchdown) {
    log_.touchdown = FlightLog::FirstContact{history_.back().truth, truth};
  }
  is_clear_of_ground_ = !truth.gear_in_contact && !history_.empty();
}

const FlightRecorder::Instant& FlightRecorder::At(models::Tick tick) const {
  const models::Tick age = history_.back().truth.tick - tick;
  if (age < 0 || age >= std::ssize(history_))
    throw std::logic_error("the frame is older than the history of the recorder");
  return history_[history_.size() - 1 - static_cast<std::size_t>(age)];
}

const FrameRecord& FlightRecorder::OnFrame(const estimator::FrameResult& estimate, double render_ms,
                                           const VisionTime& vision) {
  const Instant& instant = At(estimate.mid_exposure);
  FrameRecord record;
  record.delivered = history_.back().truth.tick;
  record.mid_exposure = estimate.mid_exposure;
  record.phase = phase_;
  record.status = estimate.status;
  record.reason = estimate.reason;
  record.pose = estimate.pose;
  record.pad_px = estimate.pad_px;
  record.X_WB = instant.truth.X_WB;
  record.pad_is_covered = instant.pad_is_covered;
  if (has_pad_ && !instant.pad_is_covered) {
    record.true_pad_px = camera_.Project(instant.X_WC.inverse() * Eigen::Vector3d::Zero());
    record.ring_in_view = WholeRingInView(camera_, pad_, instant.X_WC);
  }
  record.render_ms = render_ms;
  record.vision_ms = vision.total_ms;
  record.geometry_ms = vision.geometry_ms;
  log_.frames.push_back(std::move(record));
  return log_.frames.back();
}

void FlightRecorder::OnControl(const models::VehicleEstimate& estimate, const controller::ControlOutput& control) {
  log_.ticks.push_back({history_.back().truth, estimate, control});
}

FlightLog FlightRecorder::Finish(Outcome outcome, std::string reason) {
  log_.end = history_.empty() ? 0 : history_.back().truth.tick;
  log_.outcome = outcome;
  log_.reason = std::move(reason);
  return std::move(log_);
}

}  // namespace touchdown::runner
