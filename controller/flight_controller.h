#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/attitude_controller.h"
#include "controller/guidance.h"
#include "controller/mixer.h"
#include "controller/position_controller.h"
#include "models/signals.h"
#include "models/vehicle.h"

namespace touchdown::controller {

struct FlightControllerConfig {
  GuidanceConfig guidance;
  PositionControllerConfig position;
  AttitudeControllerConfig attitude;

  void Validate() const;
};

/// What the controller did on an IMU tick: the command, and what led to it, for the logs.
struct ControlOutput {
  models::RotorCommand rotors;
  Phase phase = Phase::kStandby;
  Eigen::Vector3d set_point_m = Eigen::Vector3d::Zero();  ///< In W.
  models::TaitBryan attitude_set_point;
  double thrust_n = 0.0;  ///< Collective, achieved after saturation.
};

/// Guidance, position loop, attitude loop and mixer in a row (Sec. V): one Update at every IMU sample.
class FlightController {
 public:
  FlightController(const FlightControllerConfig& config, const models::Vehicle& vehicle, const models::TimeBase& time,
                   int rate_hz, std::vector<Manoeuvre> script, bool starts_airborne);

  ControlOutput Update(const models::VehicleEstimate& estimate);
};

}  // namespace touchdown::controller
