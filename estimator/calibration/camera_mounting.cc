#include "estimator/calibration/camera_mounting.h"

#include <vector>

#include "models/error.h"

namespace touchdown::estimator::calibration {

Eigen::Isometry3d CameraInBody(const PatternView& view) { return view.X_WB.inverse() * view.X_WE * view.X_EC; }

PoseMean FindCameraMounting(std::span<const PatternView> views) {
  if (views.empty()) throw InputError("calibration needs at least one view of the pattern");
  std::vector<Eigen::Isometry3d> mountings;
  for (const PatternView& view : views) mountings.push_back(CameraInBody(view));
  return MeanPose(mountings);
}

}  // namespace touchdown::estimator::calibration
