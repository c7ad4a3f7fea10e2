#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "controller/attitude_controller.h"
#include "controller/guidance.h"
#include "controller/mixer.h"
#include "controller/motion_predictor.h"
#include "controller/pad_watch.h"
#include "controller/position_controller.h"
#include "models/describe.h"
#include "models/signals.h"
#include "models/vehicle.h"

namespace touchdown::controller {

/// Name and options of the controller.
struct FlightControllerConfig {
  std::string name = "paper";  ///< One of ControllerNames().
  GuidanceConfig guidance;
  PositionControllerConfig position;
  AttitudeControllerConfig attitude;
  double vision_fresh_s = 0.07;

  /// Throws InputError for a value out of its range (see Describe) or for an invalid sub-configuration.
  void Validate() const;
};

/// Allowed values of FlightControllerConfig::name.
std::vector<std::string> ControllerNames();

/// Throws InputError if `name` is not one of ControllerNames(); the message lists them.
void RequireControllerName(const std::string& name);

void Describe(models::ConfigVisitor& v, FlightControllerConfig& config);

/// Output of the controller at an IMU tick: the command and its intermediate values, for the logs.
struct ControlOutput {
  models::RotorCommand rotors;
  Phase phase = Phase::kStandby;
  Eigen::Vector3d set_point_m = Eigen::Vector3d::Zero();  ///< In W.
  models::TaitBryan attitude_set_point;
  double thrust_n = 0.0;                                 ///< Collective thrust after saturation.
  Eigen::Vector3d torque_n_m = Eigen::Vector3d::Zero();  ///< In B, after saturation.
  models::VehicleEstimate::Motion motion;                ///< Input of the position loop: from vision, or predicted.
  bool motion_is_predicted = true;
  bool script_done = false;  ///< Every maneuver is complete, so a flight that ends in the air may stop.
};

/// Cascade of guidance, position loop, attitude loop and mixer (Sec. V), with one Update per IMU sample.
class FlightController {
 public:
  /// Throws InputError for a configuration, a rate or a script that cannot be flown (see Guidance).
  FlightController(const FlightControllerConfig& config, const models::Vehicle& vehicle, const models::TimeBase& time,
                   int rate_hz, std::vector<Maneuver> script, bool starts_airborne);

  ControlOutput Update(const models::VehicleEstimate& estimate);

  /// Phase after the newest Update. In kStandby the vehicle is at rest on the ground.
  Phase phase() const { return guidance_.phase(); }

 private:
  bool MotionIsPredicted(const models::VehicleEstimate& estimate) const;
  PositionController::Demand Follow(const Guidance::Output& guidance, const models::VehicleEstimate::Motion& motion,
                                    const models::TaitBryan& attitude);
  void ResetOnGround(const models::TaitBryan& attitude);
  void Integrate(const ControlOutput& output, const Guidance::Output& guidance);

  FlightControllerConfig config_;
  double weight_n_;
  double standing_height_m_;
  PadWatch pad_;
  Guidance guidance_;
  PositionController position_;
  AttitudeController attitude_;
  Mixer mixer_;
  MotionPredictor predictor_;
};

}  // namespace touchdown::controller
