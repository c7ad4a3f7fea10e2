#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "controller/transition_table.h"
#include "models/describe.h"
#include "models/signals.h"
#include "models/time.h"

namespace touchdown::controller {

/// One maneuver of the script.
struct Maneuver {
  using Kind = ManeuverKind;
  Kind kind = Kind::kHover;
  Eigen::Vector3d position_m{0.0, 0.0, 1.0};  ///< Set-point in W; a takeoff uses its height only.
  double duration_s = 0.0;
};

void Describe(models::ConfigVisitor& v, Maneuver& maneuver);

/// Options of the guidance. Heights refer to the origin of the body in W, clearances to the landing gear contact points
/// above the pad.
struct GuidanceConfig {
  double standby_s = 1.0;

  // Blind climb.
  double start_thrust_ratio = 0.8;
  double thrust_ratio_rate_1_s = 0.2;
  double max_thrust_ratio = 1.12;
  double blind_climb_limit_s = 4.0;
  double blind_climb_limit_m = 0.8;

  // Ramp to the takeoff height.
  double climb_rate_m_s = 0.30;
  double arrival_error_m = 0.08;
  double ramp_limit_s = 20.0;

  // Landing in steps, inside the truncated cone Q' (Sec. V, Fig. 3).
  double cone_radius_m = 0.03;
  double cone_half_angle_deg = 10.0;
  double h_err_m = 0.06;
  double t_0_s = 0.10;
  double h_step_m = 0.10;
  double step_rate_m_s = 0.40;
  double braking_m_s2 = 0.25;
  double landing_limit_s = 60.0;

  // Blind descent.
  double blind_clearance_m = 0.11;
  double vision_floor_clearance_m = 0.05;
  double blind_entry_speed_m_s = 0.10;
  double blind_descent_rate_m_s = 0.20;
  double h_land_clearance_m = -0.025;

  // Loss of the pad.
  double pad_lost_s = 0.30;
  double pad_found_s = 0.10;
  double hold_limit_s = 0.6;
  double search_climb_rate_m_s = 0.40;
  double search_climb_limit_s = 5.0;
  double search_climb_m = 1.0;

  /// Throws InputError for a value out of its range (see Describe), or when values contradict each other.
  void Validate() const;
};

void Describe(models::ConfigVisitor& v, GuidanceConfig& config);

/// Guidance by set-points (Sec. V). It determines the phase of the flight and the set-point of the position loop.
class Guidance {
 public:
  /// Inputs of a tick.
  struct Input {
    models::Tick tick = 0;
    models::VehicleEstimate::Motion motion;  ///< From vision while it is fresh, predicted otherwise.
    bool pad_lost = true;                    ///< See PadWatch.
    bool pad_found = false;
  };
  struct Output {
    Phase phase = Phase::kStandby;
    Eigen::Vector3d p_m = Eigen::Vector3d::Zero();    ///< Set-point in W.
    Eigen::Vector3d v_m_s = Eigen::Vector3d::Zero();  ///< Its velocity.
    double thrust_ratio = 0.0;                        ///< Blind climb only: thrust over nominal weight.
    bool script_done = false;                         ///< Every maneuver of the script is complete.
  };

  /// `period_s` is the time between two calls of Update, `standing_height_m` the height of the body when the
  /// vehicle stands on its gear. Throws InputError for an invalid script: one that is empty, takes off in the air,
  /// starts on the ground without a takeoff, continues after a landing, or has a set-point below the blind height or a
  /// negative duration.
  Guidance(const GuidanceConfig& config, const models::TimeBase& time, double period_s, double standing_height_m,
           std::vector<Maneuver> script, bool starts_airborne);

  Output Update(const Input& input);

  Phase phase() const { return phase_; }

 private:
  std::optional<ManeuverKind> Task() const;
  double BlindHeight() const { return standing_height_m_ + config_.blind_clearance_m; }
  double LandHeight() const { return standing_height_m_ + config_.h_land_clearance_m; }
  double ConeRadiusAt(double height_m) const;

  Conditions Judge(const Input& input) const;
  void Enter(Phase phase, const Input& input);
  void FinishManeuver(Phase left, Phase entered);
  void MoveSetPoint(const Input& input);
  void FlyHover();
  void StepDown(const Input& input);
  void MoveHeight(double target_m, double rate_m_s);

  GuidanceConfig config_;
  models::TimeBase time_;
  PhaseLimits limits_;
  double period_s_;
  double standing_height_m_;
  std::vector<Maneuver> script_;
  std::size_t step_ = 0;  ///< Index of the maneuver in the script.

  Phase phase_;
  models::Tick now_ = 0, previous_ = 0, entered_ = 0;
  bool begun_ = false;
  bool pad_known_ = false;  ///< The pad was found at least once, so positions are valid.
  double entry_height_m_ = 0.0;
  models::Tick hovered_ = 0;  ///< Hover time of the current maneuver.

  double landing_height_m_ = 0.0;                ///< Height of P_set (Sec. V), towards which the set-point moves.
  std::optional<models::Tick> satisfied_since_;  ///< Time since which the vehicle is in Q' and close to P_set.
  Eigen::Vector3d p_m_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d v_m_s_ = Eigen::Vector3d::Zero();
};

}  // namespace touchdown::controller
