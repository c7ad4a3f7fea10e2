#include "controller/guidance.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "controller/validate.h"
#include "models/error.h"

namespace touchdown::controller {
namespace {

PhaseLimits LimitsOf(const GuidanceConfig& config, const models::TimeBase& time) {
  const double blind_path_m = config.blind_clearance_m + config.h_err_m - config.h_land_clearance_m;
  PhaseLimits limits;
  const auto set = [&](Phase phase, double limit_s) {
    limits[static_cast<std::size_t>(phase)] = time.FromSeconds(limit_s);
  };
  set(Phase::kStandby, config.standby_s);
  set(Phase::kBlindClimb, config.blind_climb_limit_s);
  set(Phase::kRamp, config.ramp_limit_s);
  set(Phase::kLanding, config.landing_limit_s);
  set(Phase::kBlindDescent, 1.5 * blind_path_m / config.blind_descent_rate_m_s);
  set(Phase::kHold, config.hold_limit_s);
  set(Phase::kSearchClimb, config.search_climb_limit_s);
  return limits;
}

void RequireFlyable(const std::vector<Manoeuvre>& script, bool starts_airborne, double blind_height_m) {
  if (script.empty()) throw InputError("the script is empty");
  for (std::size_t i = 0; i < script.size(); ++i) {
    const Manoeuvre& manoeuvre = script[i];
    const std::string which = "step " + std::to_string(i + 1) + " of the script: ";
    const bool on_ground = i == 0 && !starts_airborne;
    if (on_ground != (manoeuvre.kind == ManoeuvreKind::kTakeoff)) {
      throw InputError(which + (on_ground ? "a vehicle on the ground must take off first"
                                          : "a takeoff can only come first, and only from the ground"));
    }
    if (manoeuvre.kind == ManoeuvreKind::kLand) {
      if (i + 1 != script.size()) throw InputError(which + "nothing can follow a landing");
      continue;
    }
    if (!manoeuvre.position_m.allFinite() || manoeuvre.position_m.z() < blind_height_m) {
      throw InputError(which + "the set-point must be finite and above the blind height");
    }
    RequireNotNegative(manoeuvre.duration_s, "the duration of a hover");
  }
}

}  // namespace

void GuidanceConfig::Validate() const {
  RequireNotNegative(standby_s, "standby");
  RequireNotNegative(start_thrust_ratio, "start_thrust_ratio");
  RequirePositive(thrust_ratio_rate_1_s, "thrust_ratio_rate");
  RequirePositive(max_thrust_ratio, "max_thrust_ratio");
  RequirePositive(blind_climb_limit_s, "blind_climb_limit");
  RequirePositive(blind_climb_limit_m, "blind_climb_limit (height)");
  RequirePositive(climb_rate_m_s, "climb_rate");
  RequirePositive(arrival_error_m, "arrival_error");
  RequirePositive(ramp_limit_s, "ramp_limit");
  RequirePositive(cone_radius_m, "cone_radius");
  RequireNotNegative(cone_half_angle_rad, "cone_half_angle");
  RequirePositive(h_err_m, "h_err");
  RequireNotNegative(t_0_s, "t_0");
  RequirePositive(h_step_m, "h_step");
  RequirePositive(step_rate_m_s, "step_rate");
  RequirePositive(braking_m_s2, "braking");
  RequirePositive(landing_limit_s, "landing_limit");
  RequirePositive(blind_clearance_m, "blind_clearance");
  RequirePositive(blind_entry_speed_m_s, "blind_entry_speed");
  RequirePositive(blind_descent_rate_m_s, "blind_descent_rate");
  RequirePositive(pad_lost_s, "pad_lost");
  RequireNotNegative(pad_found_s, "pad_found");
  RequirePositive(hold_limit_s, "hold_limit");
  RequirePositive(search_climb_rate_m_s, "search_climb_rate");
  RequirePositive(search_climb_limit_s, "search_climb_limit");
  RequirePositive(search_climb_m, "search_climb");
  if (!std::isfinite(h_land_clearance_m) || h_land_clearance_m >= blind_clearance_m) {
    throw InputError("h_land_clearance must be finite and below blind_clearance");
  }
  if (!std::isfinite(vision_floor_clearance_m) || vision_floor_clearance_m > blind_clearance_m) {
    throw InputError("vision_floor_clearance must be finite and not above blind_clearance");
  }
  if (max_thrust_ratio < start_thrust_ratio) throw InputError("max_thrust_ratio must not be below start_thrust_ratio");
  if (cone_half_angle_rad >= models::kPi / 2.0) throw InputError("cone_half_angle must be below 90 degrees");
}

Guidance::Guidance(const GuidanceConfig& config, const models::TimeBase& time, double period_s,
                   double standing_height_m, std::vector<Manoeuvre> script, bool starts_airborne)
    : config_(config),
      time_(time),
      limits_(LimitsOf(config, time)),
      period_s_(period_s),
      standing_height_m_(standing_height_m),
      script_(std::move(script)),
      phase_(starts_airborne ? Phase::kHold : Phase::kStandby) {
  config.Validate();
  RequireFlyable(script_, starts_airborne, BlindHeight());
}

Guidance::Output Guidance::Update(const Input& input) {
  now_ = input.tick;
  if (!begun_) {
    previous_ = now_;
    Enter(phase_, input);
  }
  begun_ = true;
  pad_known_ = pad_known_ || input.pad_found;

  const Phase next = NextPhase(phase_, Judge(input), now_ - entered_, limits_);
  if (next != phase_) {
    FinishManoeuvre(phase_, next);
    Enter(next, input);
  }
  MoveSetPoint(input);
  previous_ = now_;

  Output output{.phase = phase_, .p_m = p_m_, .v_m_s = v_m_s_, .script_done = !Task().has_value()};
  if (phase_ == Phase::kBlindClimb) {
    output.thrust_ratio =
        std::min(config_.max_thrust_ratio,
                 config_.start_thrust_ratio + config_.thrust_ratio_rate_1_s * time_.ToSeconds(now_ - entered_));
  }
  return output;
}

std::optional<ManoeuvreKind> Guidance::Task() const {
  if (step_ >= script_.size()) return std::nullopt;
  return script_[step_].kind;
}

double Guidance::ConeRadiusAt(double height_m) const {
  return config_.cone_radius_m + std::max(0.0, height_m - BlindHeight()) * std::tan(config_.cone_half_angle_rad);
}

Conditions Guidance::Judge(const Input& input) const {
  const double height_m = input.motion.p_WB.z();
  Conditions conditions{.task = Task(), .pad_lost = input.pad_lost, .pad_found = input.pad_found};
  if (phase_ == Phase::kBlindClimb && height_m < standing_height_m_ + config_.vision_floor_clearance_m) {
    conditions.pad_found = false;
  }
  conditions.arrived = Task() == ManoeuvreKind::kTakeoff && p_m_.z() == script_[step_].position_m.z() &&
                       std::abs(height_m - p_m_.z()) < config_.arrival_error_m;
  conditions.ready_for_blind_descent = phase_ == Phase::kLanding && landing_height_m_ == BlindHeight() &&
                                       satisfied_since_.has_value() &&
                                       now_ - *satisfied_since_ >= time_.FromSeconds(config_.t_0_s) &&
                                       input.motion.v_WB.norm() < config_.blind_entry_speed_m_s;
  conditions.low_enough = height_m <= LandHeight();
  conditions.high_enough = height_m - entry_height_m_ >=
                           (phase_ == Phase::kBlindClimb ? config_.blind_climb_limit_m : config_.search_climb_m);
  return conditions;
}

void Guidance::FinishManoeuvre(Phase left, Phase entered) {
  const bool took_off = left == Phase::kRamp && entered == Phase::kHover;
  if (took_off || entered == Phase::kTouchdown) ++step_;
}

void Guidance::Enter(Phase phase, const Input& input) {
  const Phase left = phase_;
  const Eigen::Vector3d& p_WB = input.motion.p_WB;
  phase_ = phase;
  entered_ = now_;
  entry_height_m_ = p_WB.z();
  satisfied_since_.reset();
  v_m_s_.setZero();
  switch (phase) {
    case Phase::kStandby:
    case Phase::kBlindClimb:
    case Phase::kTouchdown:
      p_m_ = p_WB;
      break;
    case Phase::kRamp:
    case Phase::kBlindDescent:
      p_m_ = {0.0, 0.0, p_WB.z()};
      break;
    case Phase::kLanding:
      p_m_ = {0.0, 0.0, std::max(BlindHeight(), left == Phase::kHover ? p_m_.z() : p_WB.z())};
      landing_height_m_ = p_m_.z();
      break;
    case Phase::kHold:
      if (!pad_known_) p_m_ = p_WB;
      break;
    case Phase::kHover:
    case Phase::kSearchClimb:
    case Phase::kGaveUp:
      break;
  }
}

void Guidance::MoveSetPoint(const Input& input) {
  v_m_s_.setZero();
  switch (phase_) {
    case Phase::kRamp:
      if (Task() == ManoeuvreKind::kTakeoff) MoveHeight(script_[step_].position_m.z(), config_.climb_rate_m_s);
      break;
    case Phase::kHover:
      FlyHover();
      break;
    case Phase::kLanding:
      StepDown(input);
      break;
    case Phase::kBlindDescent:
      MoveHeight(LandHeight() - 1.0, config_.blind_descent_rate_m_s);
      break;
    case Phase::kSearchClimb:
      MoveHeight(std::max(p_m_.z(), entry_height_m_ + config_.search_climb_m), config_.search_climb_rate_m_s);
      break;
    default:
      break;
  }
}

void Guidance::FlyHover() {
  if (Task() != ManoeuvreKind::kHover) return;
  const Manoeuvre& manoeuvre = script_[step_];
  p_m_ = manoeuvre.position_m;
  hovered_ += now_ - previous_;
  if (hovered_ < time_.FromSeconds(manoeuvre.duration_s)) return;
  hovered_ = 0;
  ++step_;
}

void Guidance::StepDown(const Input& input) {
  const Eigen::Vector3d& p_WB = input.motion.p_WB;
  const bool satisfied =
      p_WB.head<2>().norm() < ConeRadiusAt(p_WB.z()) && std::abs(p_WB.z() - landing_height_m_) < config_.h_err_m;
  if (!satisfied) {
    satisfied_since_.reset();
  } else if (!satisfied_since_.has_value()) {
    satisfied_since_ = now_;
  } else if (now_ - *satisfied_since_ >= time_.FromSeconds(config_.t_0_s) && landing_height_m_ > BlindHeight()) {
    landing_height_m_ = std::max(BlindHeight(), landing_height_m_ - config_.h_step_m);
    satisfied_since_.reset();
  }
  const double braking_way_m = p_m_.z() - BlindHeight();
  const double braking_rate = std::sqrt(2.0 * config_.braking_m_s2 * std::max(0.0, braking_way_m));
  constexpr double kLeastRate_m_s = 0.05;
  MoveHeight(landing_height_m_,
             std::clamp(braking_rate, std::min(kLeastRate_m_s, config_.step_rate_m_s), config_.step_rate_m_s));
}

void Guidance::MoveHeight(double target_m, double rate_m_s) {
  const double step_m = rate_m_s * period_s_;
  const double way_m = target_m - p_m_.z();
  if (std::abs(way_m) <= step_m) {
    p_m_.z() = target_m;
    return;
  }
  p_m_.z() += std::copysign(step_m, way_m);
  v_m_s_.z() = std::copysign(rate_m_s, way_m);
}

}  // namespace touchdown::controller
