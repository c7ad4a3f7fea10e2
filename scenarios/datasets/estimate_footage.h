#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/datasets/footage.h"

namespace touchdown::datasets {

/// What the estimator works with on footage.
struct FootageSetup {
  models::CameraModel camera;
  models::LandingPad pad;
  std::optional<SensorMounting> mounting;  ///< nullopt: poses are X_WC, of the camera.
  /// Rising in time; empty without an IMU. Without a mounting its axes are those of a vehicle whose camera looks down,
  /// the image's up forward.
  std::vector<ImuReading> imu;
  estimator::EstimatorConfig estimator;
  estimator::AttitudeEstimatorConfig attitude_estimator;
};

/// What the estimator made of a frame of footage. Of its trace the components are only there while the frame is shown
/// to an observer.
struct FootageEstimate {
  std::string source;
  std::optional<models::Tick> mid_exposure;
  estimator::FrameEstimate seen;
};

/// Sees every frame with what the estimator made of it. It may throw to stop.
using FootageObserver = std::function<void(const FootageFrame&, const FootageEstimate&)>;

/// Runs the estimator over footage from where it is to its end. Poses are unfiltered. With an IMU gravity is as the
/// attitude estimator has it at mid-exposure, which is told of yaw by the poses as in flight; a recording of a flight
/// gives the flight's own poses, to the last bit. Without, the estimator chooses between a circle's poses by itself
/// (estimator::PoseChoice). The pad looks the same turned by 180 degrees: the body, or without a mounting the image's
/// up, points within 90 degrees of X_W.
///
/// `observer` may be null. Throws InputError, naming the frame's file, for a frame that cannot be read or is of another
/// size than the camera's; for an IMU beside frames without times; and for a setup that is not valid.
std::vector<FootageEstimate> EstimateFootage(Footage& footage, const FootageSetup& setup,
                                             const FootageObserver& observer = nullptr);

}  // namespace touchdown::datasets
