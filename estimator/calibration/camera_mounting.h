#pragma once

#include <Eigen/Geometry>
#include <span>

#include "estimator/calibration/pose_mean.h"

namespace touchdown::estimator::calibration {

/// Measurements from one view of a calibration pattern (Sec. III-D). E is the pattern's frame.
struct PatternView {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();  ///< Body, from the tracking system.
  Eigen::Isometry3d X_WE = Eigen::Isometry3d::Identity();  ///< Pattern, from the tracking system.
  Eigen::Isometry3d X_EC = Eigen::Isometry3d::Identity();  ///< Camera, from its image of the pattern.
};

/// The camera's pose in the body frame, X_BC = X_WB^-1 X_WE X_EC (Eq. 2).
Eigen::Isometry3d CameraInBody(const PatternView& view);

/// Mean of Eq. 2 over several views; its X_AB is X_BC. Throws InputError for no views.
///
/// The scatter does not include errors common to all views: an error of the camera's principal point, which looks like
/// a rotation of the camera, and errors of the frames that the tracking system assigns to vehicle and pattern.
PoseMean FindCameraMounting(std::span<const PatternView> views);

}  // namespace touchdown::estimator::calibration
