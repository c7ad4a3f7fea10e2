#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>

#include "models/camera_model.h"
#include "models/landing_pad.h"
#include "models/time.h"

namespace touchdown::estimator {

/// Relation between the frames that an estimator receives.
enum class FrameOrder {
  kFlight,     ///< A flight that starts on the pad: the first pose is near (0, 0, 0.3 m) and level (Sec. VI-B.1). A
               ///< frame without a detection is acceptable, because the next one follows soon. For the other two values
               ///< the estimator may spend more time on each frame.
  kSequence,   ///< A video that starts at any pose.
  kUnrelated,  ///< Independent images.
};

/// The two stages of processing a frame that the paper times separately (Sec. VI-B.4).
enum class FrameStage {
  kRecognition,  ///< From the image to pad candidates (Sec. IV-A).
  kGeometry,     ///< From pad candidates to the pose: edges, ellipses, pose (Secs. IV-B and IV-C).
};

/// Inputs common to all estimators: assumed calibration, pad geometry, clock.
struct EstimatorSetup {
  models::CameraModel camera;
  models::LandingPad pad;
  Eigen::Isometry3d X_BC = Eigen::Isometry3d::Identity();  ///< Calibrated pose of the camera in the body frame.
  Eigen::Matrix3d R_BU = Eigen::Matrix3d::Identity();      ///< Calibrated orientation of the IMU in the body frame.
  models::TimeBase time;
  FrameOrder frame_order = FrameOrder::kFlight;
  /// Called when processing of a frame enters a stage, for timing; may be empty.
  std::function<void(FrameStage)> on_stage = nullptr;
};

}  // namespace touchdown::estimator
