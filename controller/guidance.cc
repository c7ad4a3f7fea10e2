#include "controller/guidance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "models/angles.h"
#include "models/error.h"

namespace touchdown::controller {
namespace {

using models::kMeter, models::kMeterPerSecond, models::kNoUnit, models::kPositive, models::kPositiveTime,
    models::kSecond, models::kTime;

constexpr std::array<std::string_view, 3> kManeuverNames = {"takeoff", "hover", "land"};

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

void RequireFlyable(const std::vector<Maneuver>& script, bool starts_airborne, double blind_height_m) {
  if (script.empty()) throw InputError("the script is empty");
  for (std::size_t i = 0; i < script.size(); ++i) {
    const Maneuver& maneuver = script[i];
    const std::string which = "step " + std::to_string(i + 1) + " of the script: ";
    const bool on_ground = i == 0 && !starts_airborne;
    if (on_ground != (maneuver.kind == ManeuverKind::kTakeoff)) {
      throw InputError(which + (on_ground ? "a vehicle on the ground must take off first"
                                          : "a takeoff is allowed only as the first step, from the ground"));
    }
    if (maneuver.kind == ManeuverKind::kLand) {
      if (i + 1 != script.size()) throw InputError(which + "no maneuver may follow a landing");
      continue;
    }
    if (!maneuver.position_m.allFinite() || maneuver.position_m.z() < blind_height_m) {
      throw InputError(which + "the set-point must be finite and above the blind height");
    }
    if (!std::isfinite(maneuver.duration_s) || maneuver.duration_s < 0.0) {
      throw InputError(which + "the duration of a hover must be finite and not negative");
    }
  }
}

void RequireConsistent(const GuidanceConfig& c) {
  if (c.h_land_clearance_m >= c.blind_clearance_m) {
    throw InputError("h_land_clearance_m must be below blind_clearance_m");
  }
  if (c.vision_floor_clearance_m > c.blind_clearance_m) {
    throw InputError("vision_floor_clearance_m must not be above blind_clearance_m");
  }
  if (c.max_thrust_ratio < c.start_thrust_ratio) {
    throw InputError("max_thrust_ratio must not be below start_thrust_ratio");
  }
}

void DescribeTakeoff(models::ConfigVisitor& v, GuidanceConfig& c) {
  v.Number({"standby_s", "Time on the ground before takeoff, during which the estimate of the IMU settles."},
           c.standby_s, kSecond, kTime);
  v.Number({"start_thrust_ratio", "Thrust over weight at the start of the blind climb."}, c.start_thrust_ratio, kNoUnit,
           models::kNotNegative);
  v.Number({"thrust_ratio_rate_1_s",
            "Rate at which thrust over weight grows in the blind climb. Larger takes off sooner and faster."},
           c.thrust_ratio_rate_1_s, models::kPerSecond, kPositive);
  v.Number(
      {"max_thrust_ratio",
       "Largest thrust over weight in the blind climb. Its excess over 1 is the largest payload that takes off, as a "
       "fraction of the mass."},
      c.max_thrust_ratio, kNoUnit, kPositive);
  v.Number({"blind_climb_limit_s", "Longest climb without a view of the pad."}, c.blind_climb_limit_s, kSecond,
           kPositiveTime);
  v.Number({"blind_climb_limit_m", "Highest predicted climb without a view of the pad."}, c.blind_climb_limit_m, kMeter,
           kPositive);
  v.Number({"climb_rate_m_s", "Rate at which the set-point rises to the height of the takeoff."}, c.climb_rate_m_s,
           kMeterPerSecond, kPositive);
  v.Number({"arrival_error_m", "Height error below which the takeoff is complete."}, c.arrival_error_m, kMeter,
           kPositive);
  v.Number({"ramp_limit_s", "Longest climb to the height of the takeoff."}, c.ramp_limit_s, kSecond, kPositiveTime);
}

void DescribeLanding(models::ConfigVisitor& v, GuidanceConfig& c) {
  v.Number({"cone_radius_m",
            "Radius of the cone Q' at its bottom, the blind height. A larger radius lands sooner and less accurately."},
           c.cone_radius_m, kMeter, kPositive);
  v.Number(
      {"cone_half_angle_deg", "Half-angle of the cone Q'. A larger angle accepts larger offsets high above the pad."},
      c.cone_half_angle_deg, models::kDegree, models::Between(0.0, 80.0));
  v.Number({"h_err_m", "Height error below which a step of the landing counts as reached."}, c.h_err_m, kMeter,
           kPositive);
  v.Number({"t_0_s",
            "Time that the vehicle stays in Q' and within h_err_m before the next step. A longer time lands later and "
            "more steadily."},
           c.t_0_s, kSecond, kTime);
  v.Number({"h_step_m", "Height of a landing step."}, c.h_step_m, kMeter, kPositive);
  v.Number({"step_rate_m_s", "Rate at which the set-point descends through a step."}, c.step_rate_m_s, kMeterPerSecond,
           kPositive);
  v.Number({"braking_m_s2", "Deceleration of the set-point towards the blind height. Larger brakes later and harder."},
           c.braking_m_s2, models::kMeterPerSecond2, kPositive);
  v.Number({"landing_limit_s", "Longest landing, from its start to the blind descent."}, c.landing_limit_s, kSecond,
           kPositiveTime);
  v.Number({"blind_clearance_m",
            "Clearance of the landing gear at which the blind descent begins. Below it the ring may be larger than the "
            "image."},
           c.blind_clearance_m, kMeter, kPositive);
  v.Number({"vision_floor_clearance_m",
            "Clearance of the landing gear below which the blind climb and descent do not use vision."},
           c.vision_floor_clearance_m, kMeter, models::kNotNegative);
  v.Number({"blind_entry_speed_m_s",
            "Largest speed, in any direction, at which the blind descent may begin. A lower speed waits for a steadier "
            "hover."},
           c.blind_entry_speed_m_s, kMeterPerSecond, kPositive);
  v.Number({"blind_descent_rate_m_s", "Rate of the blind descent."}, c.blind_descent_rate_m_s, kMeterPerSecond,
           kPositive);
  v.Number({"h_land_clearance_m",
            "Predicted clearance of the landing gear at which the motors stop. A value below 0 avoids a drop when the "
            "predicted height is too low by up to this amount."},
           c.h_land_clearance_m, kMeter, models::Between(-1.0, 1.0));
}

void DescribeSearch(models::ConfigVisitor& v, GuidanceConfig& c) {
  v.Number({"pad_lost_s", "Time without a detection after which the pad counts as lost."}, c.pad_lost_s, kSecond,
           kPositiveTime);
  v.Number({"pad_found_s", "Time of uninterrupted detections after which the pad counts as found."}, c.pad_found_s,
           kSecond, kTime);
  v.Number({"hold_limit_s", "Time that the vehicle holds its position after the pad is lost, before it climbs."},
           c.hold_limit_s, kSecond, kPositiveTime);
  v.Number({"search_climb_rate_m_s", "Rate at which the vehicle climbs after hold_limit_s, to see more of the ground."},
           c.search_climb_rate_m_s, kMeterPerSecond, kPositive);
  v.Number({"search_climb_limit_s", "Longest search climb before the vehicle gives up."}, c.search_climb_limit_s,
           kSecond, kPositiveTime);
  v.Number({"search_climb_m", "Highest predicted search climb before the vehicle gives up."}, c.search_climb_m, kMeter,
           kPositive);
}

}  // namespace

void Describe(models::ConfigVisitor& v, Maneuver& m) {
  v.Choice({"do", "Maneuver to fly.", true}, m.kind, kManeuverNames);
  switch (m.kind) {
    case ManeuverKind::kTakeoff:
      v.Number({"height_m", "Height of the body's origin above the pad at the end of the takeoff (takeoff only)."},
               m.position_m.z(), kMeter, models::PositiveUpTo(20.0));
      break;
    case ManeuverKind::kHover:
      v.Vector3({"position_m", "Set-point of the body's origin in W (hover only)."}, m.position_m, kMeter,
                models::Between(-15.0, 15.0));
      v.Number({"duration_s", "Duration of the hover (hover only).", true}, m.duration_s, kSecond, kTime);
      break;
    case ManeuverKind::kLand:
      break;
  }
}

void Describe(models::ConfigVisitor& v, GuidanceConfig& c) {
  DescribeTakeoff(v, c);
  DescribeLanding(v, c);
  DescribeSearch(v, c);
  v.Check("", [&c] { RequireConsistent(c); });
}

void GuidanceConfig::Validate() const { models::ValidateConfig(*this); }

Guidance::Guidance(const GuidanceConfig& config, const models::TimeBase& time, double period_s,
                   double standing_height_m, std::vector<Maneuver> script, bool starts_airborne)
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
    FinishManeuver(phase_, next);
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

std::optional<ManeuverKind> Guidance::Task() const {
  if (step_ >= script_.size()) return std::nullopt;
  return script_[step_].kind;
}

double Guidance::ConeRadiusAt(double height_m) const {
  return config_.cone_radius_m +
         std::max(0.0, height_m - BlindHeight()) * std::tan(models::DegToRad(config_.cone_half_angle_deg));
}

Conditions Guidance::Judge(const Input& input) const {
  const double height_m = input.motion.p_WB.z();
  Conditions conditions{.task = Task(), .pad_lost = input.pad_lost, .pad_found = input.pad_found};
  if (phase_ == Phase::kBlindClimb && height_m < standing_height_m_ + config_.vision_floor_clearance_m) {
    conditions.pad_found = false;
  }
  conditions.arrived = Task() == ManeuverKind::kTakeoff && p_m_.z() == script_[step_].position_m.z() &&
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

void Guidance::FinishManeuver(Phase left, Phase entered) {
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
      if (Task() == ManeuverKind::kTakeoff) MoveHeight(script_[step_].position_m.z(), config_.climb_rate_m_s);
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
  if (Task() != ManeuverKind::kHover) return;
  const Maneuver& maneuver = script_[step_];
  p_m_ = maneuver.position_m;
  hovered_ += now_ - previous_;
  if (hovered_ < time_.FromSeconds(maneuver.duration_s)) return;
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
  const double braking_distance_m = p_m_.z() - BlindHeight();
  const double braking_rate = std::sqrt(2.0 * config_.braking_m_s2 * std::max(0.0, braking_distance_m));
  constexpr double kMinRate_m_s = 0.05;
  MoveHeight(landing_height_m_,
             std::clamp(braking_rate, std::min(kMinRate_m_s, config_.step_rate_m_s), config_.step_rate_m_s));
}

void Guidance::MoveHeight(double target_m, double rate_m_s) {
  const double step_m = rate_m_s * period_s_;
  const double distance_m = target_m - p_m_.z();
  if (std::abs(distance_m) <= step_m) {
    p_m_.z() = target_m;
    return;
  }
  p_m_.z() += std::copysign(step_m, distance_m);
  v_m_s_.z() = std::copysign(rate_m_s, distance_m);
}

}  // namespace touchdown::controller
