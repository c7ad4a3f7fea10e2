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
};

/// What the estimator found in a frame of footage. The overlay's boxes are present only while an observer sees the
/// frame.
struct FootageEstimate {
  std::string source;
  std::optional<models::Tick> mid_exposure;
  estimator::FrameResult seen;
};

/// Sees every frame with what the estimator made of it. It may throw to stop.
using FootageObserver = std::function<void(const FootageFrame&, const FootageEstimate&)>;

/// Runs the estimator over footage from where it is to its end. Poses are unfiltered. With an IMU the estimator is
/// given samples and frames in the order in which a vehicle has them; a recording of a flight gives the flight's own
/// poses, to the last bit. Without, the estimator chooses between a circle's poses by itself
/// (estimator::PoseChoice). The pad looks the same turned by 180 degrees: the body, or without a mounting the image's
/// up, points within 90 degrees of X_W.
///
/// `observer` may be null. Throws InputError, naming the frame's file, for a frame that cannot be read or is of another
/// size than the camera's; for an IMU beside frames without times; and for a setup that is not valid.
std::vector<FootageEstimate> EstimateFootage(Footage& footage, const FootageSetup& setup,
                                             const FootageObserver& observer = nullptr);

}  // namespace touchdown::datasets
