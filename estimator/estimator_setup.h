#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>

#include "models/camera_model.h"
#include "models/landing_pad.h"
#include "models/time.h"

namespace touchdown::estimator {

/// How the frames that an estimator is given belong together.
enum class FrameOrder {
  kFlight,     ///< A flight from the pad: the first pose is near (0, 0, 0.3 m) and level (Sec. VI-B.1), and a frame
               ///< without the pad is soon followed by one with it. In the other two orders every frame counts.
  kSequence,   ///< One video that begins anywhere.
  kUnrelated,  ///< Images that have nothing to do with each other.
};

/// The two parts of the work on a frame that the paper times apart (Sec. VI-B.4).
enum class FrameStage {
  kRecognition,  ///< From the image to what might be the pad (Sec. IV-A).
  kGeometry,     ///< From there to its pose: edges, ellipses, pose (Secs. IV-B and IV-C).
};

/// Inputs common to all estimators: assumed calibration, pad geometry, clock.
struct EstimatorSetup {
  models::CameraModel camera;
  models::LandingPad pad;
  Eigen::Isometry3d X_BC = Eigen::Isometry3d::Identity();  ///< The camera's calibrated mounting.
  Eigen::Matrix3d R_BU = Eigen::Matrix3d::Identity();      ///< The IMU's calibrated mounting.
  models::TimeBase time;
  FrameOrder frame_order = FrameOrder::kFlight;
  /// Called whenever the work on a frame reaches a stage, for timing; may be empty.
  std::function<void(FrameStage)> on_stage = nullptr;
};

}  // namespace touchdown::estimator
