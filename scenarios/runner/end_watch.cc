#include "scenarios/runner/end_watch.h"

namespace touchdown::runner {
namespace {

constexpr double kRestSpeed_m_s = 0.02;
constexpr double kRestRate_rad_s = 0.05;
constexpr double kRestTime_s = 1.0;
constexpr double kRestDeadline_s = 5.0;

}  // namespace

EndWatch::EndWatch(const Scenario& scenario)
    : time_(scenario.time),
      time_limit_(scenario.time.FromSeconds(scenario.time_limit_s)),
      half_width_m_(scenario.scene.floor_size_m / 2.0),
      ceiling_m_(scenario.ceiling_m()) {
  if (scenario.hand.carries) {
    hand_held_end_ = time_.FromSeconds(sim::Hand::kTimeAtRest_s + scenario.hand.duration_s);
  }
}

std::optional<Ending> EndWatch::Judge(const sim::TrueState& truth, const controller::ControlOutput& control) {
  if (auto danger = JudgeDanger(truth)) return danger;
  if (auto end = JudgeScript(truth, control)) return end;
  if (truth.tick >= time_limit_) return Ending{Outcome::kGaveUp, "the time limit was reached"};
  return std::nullopt;
}

std::optional<Ending> EndWatch::JudgeScript(const sim::TrueState& truth, const controller::ControlOutput& control) {
  if (hand_held_end_) {
    if (truth.tick < *hand_held_end_) return std::nullopt;
    return Ending{Outcome::kHovered, "the hand motion ended in the air"};
  }
  switch (control.phase) {
    case controller::Phase::kGaveUp:
      return Ending{Outcome::kGaveUp, "the guidance gave up"};
    case controller::Phase::kTouchdown:
      if (auto rest = JudgeRest(truth)) return rest;
      break;
    case controller::Phase::kHover:
      if (control.script_done) return Ending{Outcome::kHovered, "the script ended in the air"};
      break;
    default:
      break;
  }
  return std::nullopt;
}

std::optional<Ending> EndWatch::JudgeDanger(const sim::TrueState& truth) const {
  const Eigen::Vector3d p_WB = truth.X_WB.translation();
  if (truth.body_in_contact) return Ending{Outcome::kCrashed, "the body touched the ground or an object"};
  if (truth.X_WB.linear()(2, 2) < 0.0) return Ending{Outcome::kCrashed, "the vehicle tipped over"};
  if (p_WB.head<2>().cwiseAbs().maxCoeff() > half_width_m_ || p_WB.z() > ceiling_m_) {
    return Ending{Outcome::kCrashed, "the vehicle left the room"};
  }
  return std::nullopt;
}

std::optional<Ending> EndWatch::JudgeRest(const sim::TrueState& truth) {
  if (!motors_off_) motors_off_ = truth.tick;
  const bool rests =
      truth.gear_in_contact && truth.v_WB.norm() < kRestSpeed_m_s && truth.w_WB_B.norm() < kRestRate_rad_s;
  if (!rests) at_rest_.reset();
  if (rests && !at_rest_) at_rest_ = truth.tick;
  if (at_rest_ && truth.tick - *at_rest_ >= time_.FromSeconds(kRestTime_s)) {
    return Ending{Outcome::kLanded, "at rest on the gear, motors off"};
  }
  if (truth.tick - *motors_off_ >= time_.FromSeconds(kRestDeadline_s)) {
    return Ending{Outcome::kCrashed, "the vehicle did not come to rest after the motors stopped"};
  }
  return std::nullopt;
}

}  // namespace touchdown::runner
