#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/datasets/footage.h"

namespace touchdown::datasets {

/// Inputs of the estimator for footage.
struct FootageSetup {
  models::CameraModel camera;
  models::LandingPad pad;
  std::optional<SensorMounting> mounting;  ///< nullopt: results contain camera poses X_WC.
  /// IMU samples in increasing order of time; empty without an IMU. Without a mounting, the IMU axes are those of a
  /// vehicle whose camera looks down with the top of the image forward.
  std::vector<ImuReading> imu;
  estimator::EstimatorConfig estimator;
};

/// Estimate for one frame of footage. The boxes of the overlay are present only in the call of the observer.
struct FootageEstimate {
  std::string source;
  std::optional<models::Tick> mid_exposure;
  estimator::FrameResult result;
};

/// Called with each frame and its estimate. It may throw to stop.
using FootageObserver = std::function<void(const FootageFrame&, const FootageEstimate&)>;

/// Runs the estimator on the remaining frames of footage. Poses are unfiltered.
///
/// With an IMU, the estimator receives samples and frames in the order in which a vehicle receives them. The poses from
/// the recording of a flight are bit-identical to those of the flight. Without an IMU, the estimator chooses between
/// the two pose hypotheses from the image (estimator::PoseChoice). Yaw is ambiguous by 180 degrees: the X axis of the
/// body (without a mounting: the top of the image) points within 90 degrees of the X axis of W.
///
/// `observer` may be null. Throws InputError, naming the file, for a frame that cannot be read or whose size differs
/// from that of the camera model, for an IMU with frames that have no times, and for an invalid setup.
std::vector<FootageEstimate> EstimateFootage(Footage& footage, const FootageSetup& setup,
                                             const FootageObserver& observer = nullptr);

}  // namespace touchdown::datasets
