#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "controller/transition_table.h"
#include "models/signals.h"
#include "models/time.h"

namespace touchdown::controller {

/// One step of what the vehicle is to do.
struct Manoeuvre {
  using Kind = ManoeuvreKind;
  Kind kind = Kind::kHover;
  Eigen::Vector3d position_m{0.0, 0.0, 1.0};  ///< Takeoff (its height) and hover: the set-point in W.
  double duration_s = 0.0;                    ///< Hover only.
};

/// Heights are of the body's origin in W, clearances those of the gear's soles over the pad.
struct GuidanceConfig {
  double standby_s = 1.0;  ///< On the ground before takeoff, in which the IMU settles.

  // The blind climb: thrust as a share of the nominal weight.
  double start_thrust_ratio = 0.8;
  double thrust_ratio_rate_1_s = 0.2;
  double max_thrust_ratio = 1.12;  ///< The heaviest payload that takes off, less one.
  double blind_climb_limit_s = 4.0;
  double blind_climb_limit_m = 0.8;  ///< By prediction, over where it stood.

  double climb_rate_m_s = 0.30;   ///< Of the ramp.
  double arrival_error_m = 0.08;  ///< Height error at the end of the ramp at which the takeoff is done.
  double ramp_limit_s = 20.0;

  // Landing (Sec. V, Fig. 3): the truncated cone Q' and the steps.
  double cone_radius_m = 0.03;         ///< Of Q' at its bottom, the blind height. Wider lands sooner, further off.
  double cone_half_angle_rad = 0.175;  ///< 10 deg.
  double h_err_m = 0.06;               ///< Height error at which a step counts as reached.
  double t_0_s = 0.10;                 ///< For how long the vehicle must have been in Q' with less than h_err.
  double h_step_m = 0.10;
  double step_rate_m_s = 0.40;  ///< The set-point moves through a step at this rate, and slows down towards
  double braking_m_s2 = 0.25;   ///< the blind height by this much.
  double landing_limit_s = 60.0;

  // Blind descent.
  double blind_clearance_m = 0.11;         ///< Below it the ring may be larger than the image.
  double vision_floor_clearance_m = 0.05;  ///< Below it no sighting is used, on the way down as on the way up.
  double blind_entry_speed_m_s = 0.10;     ///< No faster, in any direction, when the blind descent begins.
  double blind_descent_rate_m_s = 0.20;
  double h_land_clearance_m = -0.025;  ///< Motors off, by prediction: h_land less the gear's height. Below 0, so that a
                                       ///< prediction that is off by this much still does not let the vehicle fall.

  // The pad is not seen.
  double pad_lost_s = 0.30;   ///< After which it counts as lost.
  double pad_found_s = 0.10;  ///< For which it must have been seen to be relied on (again).
  double hold_limit_s = 0.6;
  double search_climb_rate_m_s = 0.40;
  double search_climb_limit_s = 5.0;
  double search_climb_m = 1.0;  ///< By prediction: how far it climbs at most.

  /// Throws InputError when a number is not finite, a time, rate or length that must be positive is not, or the numbers
  /// contradict each other.
  void Validate() const;
};

/// Guidance by set-points (Sec. V): where the flight stands, and what the position loop is to follow.
class Guidance {
 public:
  /// What it is told on a tick.
  struct Input {
    models::Tick tick = 0;
    models::VehicleEstimate::Motion motion;  ///< From vision while it is fresh, predicted otherwise.
    bool pad_lost = true;                    ///< As PadWatch has it.
    bool pad_found = false;
  };
  struct Output {
    Phase phase = Phase::kStandby;
    Eigen::Vector3d p_m = Eigen::Vector3d::Zero();    ///< Set-point in W.
    Eigen::Vector3d v_m_s = Eigen::Vector3d::Zero();  ///< Its velocity.
    double thrust_ratio = 0.0;                        ///< Blind climb only: thrust over nominal weight.
    bool script_done = false;                         ///< Every manoeuvre of the script has been flown.
  };

  /// `period_s` is the time between two calls of Update, `standing_height_m` the body's height when it stands on its
  /// gear. Throws InputError when the script cannot be flown from where it starts: an empty one, a takeoff in the air,
  /// anything else on the ground, anything after a landing, a set-point below the blind height, a negative duration.
  Guidance(const GuidanceConfig& config, const models::TimeBase& time, double period_s, double standing_height_m,
           std::vector<Manoeuvre> script, bool starts_airborne);

  Output Update(const Input& input);

  Phase phase() const { return phase_; }

 private:
  std::optional<ManoeuvreKind> Task() const;
  double BlindHeight() const { return standing_height_m_ + config_.blind_clearance_m; }
  double LandHeight() const { return standing_height_m_ + config_.h_land_clearance_m; }
  double ConeRadiusAt(double height_m) const;

  Conditions Judge(const Input& input) const;
  void Enter(Phase phase, const Input& input);
  void FinishManoeuvre(Phase left, Phase entered);
  void MoveSetPoint(const Input& input);
  void FlyHover();
  void StepDown(const Input& input);
  void MoveHeight(double target_m, double rate_m_s);

  GuidanceConfig config_;
  models::TimeBase time_;
  PhaseLimits limits_;
  double period_s_;
  double standing_height_m_;
  std::vector<Manoeuvre> script_;
  std::size_t step_ = 0;  ///< In the script.

  Phase phase_;
  models::Tick now_ = 0, previous_ = 0, entered_ = 0;
  bool begun_ = false;
  bool pad_known_ = false;  ///< Found at least once: positions mean something.
  double entry_height_m_ = 0.0;
  models::Tick hovered_ = 0;  ///< Of the current manoeuvre.

  double landing_height_m_ = 0.0;                ///< Of P_set (Sec. V), towards which the set-point moves.
  std::optional<models::Tick> satisfied_since_;  ///< In Q' with little error of height.
  Eigen::Vector3d p_m_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d v_m_s_ = Eigen::Vector3d::Zero();
};

}  // namespace touchdown::controller
