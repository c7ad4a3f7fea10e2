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

/// Configuration of a flight without images: the filters of the estimator and the whole controller fly QuadrotorOde
/// with a model of vision.
struct RigConfig {
  std::uint64_t seed = 1;
  std::vector<controller::Maneuver> script;
  double time_limit_s = 40.0;
  bool starts_airborne = false;
  Eigen::Vector3d start_m{0.0, 0.0, 0.14};
  double start_yaw = 0.0;
  double mass_ratio = 1.0;  ///< True mass, relative to the mass that the controller assumes.
  Eigen::Vector3d wind_m_s = Eigen::Vector3d::Zero();

  double gyro_bias_rad_s = 0.0087;     ///< Standard deviation per axis.
  double level_bias_m_s2 = 0.196;      ///< Accelerometer bias, standard deviation per axis.
  double xy_noise_per_height = 0.030;  ///< Standard deviation; half its variance is slow (0.5 s).
  double z_noise_per_height = 0.006;   ///< Standard deviation, at least 1 mm.
  double yaw_noise_rad = 0.05;
  double detection = 0.97;  ///< Probability that a ring in view is detected.
  double latency_s = 0.025;

  /// Called before each tick. It may set wind and push. Returns whether the pad is visible.
  std::function<bool(double time_s, QuadrotorOde& truth)> events;

  controller::FlightControllerConfig controller;
  estimator::AttitudeEstimatorConfig attitude;
  estimator::PoseFilterConfig filter;
  std::ostream* log = nullptr;  ///< CSV output at 50 Hz; may be null.
};

struct RigResult {
  controller::Phase last_phase = controller::Phase::kStandby;
  std::vector<controller::Phase> phases;  ///< All phases, in order.
  bool crashed = false;
  bool script_done = false;
  std::optional<double> reached_height_s;  ///< First time within 5 cm of the first set-point's height.
  double hover_rmse_m = 0.0;
  double max_offset_m = 0.0;  ///< Largest horizontal distance from the center of the pad.
  double max_height_m = 0.0;
  double max_tilt_rad = 0.0;
  double attitude_rmse_rad = 0.0;  ///< RMSE of the estimated roll and pitch.
  double landing_s = 0.0;          ///< Time from the start of kLanding to motors off.
  struct Touchdown {
    double xy_m = 0.0, speed_m_s = 0.0, tilt_rad = 0.0, yaw_rad = 0.0;
    double motors_off_after_s = 0.0;  ///< Time after first contact; negative if the motors stop in the air.
  };
  std::optional<Touchdown> touchdown;
};

/// Flies until touchdown, the end of the script, a crash or the time limit.
RigResult Fly(const RigConfig& config);

controller::Maneuver TakeoffTo(double height_m);
controller::Maneuver HoverAt(const Eigen::Vector3d& position_m, double duration_s);
controller::Maneuver Land();

}  // namespace touchdown::tests
