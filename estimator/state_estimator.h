#pragma once

#include <Eigen/Core>
#include <memory>

#include "estimator/attitude_estimator.h"
#include "estimator/estimator.h"
#include "estimator/pose_filter.h"
#include "models/signals.h"
#include "models/time.h"

namespace touchdown::estimator {

/// All that a vehicle knows of its own state (Sec. V): roll, pitch and rates from the IMU, position, velocity and yaw
/// from vision.
class StateEstimator {
 public:
  struct Config {
    AttitudeEstimatorConfig attitude;
    PoseFilterConfig filter;
  };

  /// `vision` must not be null; `R_BU` is the calibrated mounting of the IMU. Throws InputError for a config that is
  /// not valid.
  StateEstimator(std::unique_ptr<Estimator> vision, const Config& config, const models::TimeBase& time,
                 const Eigen::Matrix3d& R_BU);

  /// Takes the next sample of the IMU. `at_rest`: the vehicle knows that it stands on the ground, motors off.
  void TakeImu(const models::ImuSample& imu, bool at_rest);

  /// Takes the next frame, in the order of their exposure, and returns what vision made of it. A frame comes late: it
  /// is judged by gravity as it was at mid-exposure. Of the two poses from which the pad looks the same
  /// (models::NearerTwin), the one nearer to the present yaw is used; a frame whose status is not ok changes nothing.
  FrameEstimate TakeFrame(const models::ImageView& image, models::Tick mid_exposure);

  /// The state at `tick`, which must not lie before the newest sample's: attitude and rates of that sample, motion as
  /// predicted from the newest frame used; nullopt before the first one.
  models::VehicleEstimate At(models::Tick tick) const;

 private:
  std::unique_ptr<Estimator> vision_;
  AttitudeEstimator attitude_;
  PoseFilter filter_;
};

}  // namespace touchdown::estimator
