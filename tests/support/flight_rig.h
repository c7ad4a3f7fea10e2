#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <vector>

#include "controller/flight_controller.h"
#include "estimator/attitude_estimator.h"
#include "estimator/pose_filter.h"
#include "models/vehicle.h"
#include "tests/support/quadrotor_ode.h"

namespace touchdown::tests {

/// A flight without pixels: the estimator's state estimation and the whole controller, around QuadrotorOde and a model
/// of what vision gives.
struct RigConfig {
  std::uint64_t seed = 1;
  std::vector<controller::Maneuver> script;
  double time_limit_s = 40.0;
  bool starts_airborne = false;
  Eigen::Vector3d start_m{0.0, 0.0, 0.14};
  double start_yaw = 0.0;
  double mass_ratio = 1.0;  ///< True mass over the one that the controller knows.
  Eigen::Vector3d wind_m_s = Eigen::Vector3d::Zero();

  double gyro_bias_rad_s = 0.0087;     ///< 1-sigma per axis.
  double level_bias_m_s2 = 0.196;      ///< Accelerometer's, 1-sigma per axis.
  double xy_noise_per_height = 0.030;  ///< 1-sigma of vision, half its variance slow (0.5 s), half white.
  double z_noise_per_height = 0.006;   ///< The same vertically, and 1 mm at least.
  double yaw_noise_rad = 0.05;
  double detection = 0.97;  ///< Probability that a ring in view is found.
  double latency_s = 0.025;

  /// Called before each tick: sets wind and push, and says whether the pad can be seen.
  std::function<bool(double time_s, QuadrotorOde& truth)> events;

  controller::FlightControllerConfig controller;
  estimator::AttitudeEstimatorConfig attitude;
  estimator::PoseFilterConfig filter;
  std::ostream* log = nullptr;  ///< CSV of 50 Hz.
};

struct RigResult {
  controller::Phase last_phase = controller::Phase::kStandby;
  std::vector<controller::Phase> phases;  ///< Every phase entered, in order.
  bool crashed = false;
  bool script_done = false;
  std::optional<double> reached_height_s;  ///< First time within 5 cm of the first set-point's height.
  double hover_rmse_m = 0.0;
  double max_offset_m = 0.0;  ///< Horizontally, from the pad's axis.
  double max_height_m = 0.0;
  double max_tilt_rad = 0.0;
  double attitude_rmse_rad = 0.0;  ///< Of estimated roll and pitch.
  double landing_s = 0.0;          ///< From the begin of kLanding to motors off.
  struct Touchdown {
    double xy_m = 0.0, speed_m_s = 0.0, tilt_rad = 0.0, yaw_rad = 0.0;
    double motors_off_after_s = 0.0;  ///< After first contact; negative: cut in the air.
  };
  std::optional<Touchdown> touchdown;
};

RigResult Fly(const RigConfig& config);

controller::Maneuver TakeoffTo(double height_m);
controller::Maneuver HoverAt(const Eigen::Vector3d& position_m, double duration_s);
controller::Maneuver Land();

}  // namespace touchdown::tests
