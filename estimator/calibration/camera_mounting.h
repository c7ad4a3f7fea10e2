#pragma once

#include <Eigen/Geometry>
#include <span>

#include "estimator/calibration/pose_mean.h"

namespace touchdown::estimator::calibration {

/// What one view of a calibration pattern gives (Sec. III-D). E is the pattern's frame.
struct PatternView {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();  ///< The vehicle, by the tracking system.
  Eigen::Isometry3d X_WE = Eigen::Isometry3d::Identity();  ///< The pattern, by the tracking system.
  Eigen::Isometry3d X_EC = Eigen::Isometry3d::Identity();  ///< The camera, by what it sees of the pattern.
};

/// Eq. 2: X_BC = X_WB^-1 X_WE X_EC, the camera's pose in the body frame.
Eigen::Isometry3d CameraInBody(const PatternView& view);

/// The mean of Eq. 2 over several views, X_AB being X_BC. Throws InputError when there is none.
///
/// What all views have in common is not in the scatter: an error of the camera's principal point, which looks like a
/// turn of the camera, and one of the tracking system's own frames on vehicle and pattern.
PoseMean FindCameraMounting(std::span<const PatternView> views);

}  // namespace touchdown::estimator::calibration
